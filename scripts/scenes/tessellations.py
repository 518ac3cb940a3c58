# SPDX-License-Identifier: Apache-2.0
"""Meshes of Lume's analytic surfaces, from their parametrisations: every vertex is on the surface,
with its exact normal and texture coordinate. `n` is the number of segments around.

The round ones turn a profile around y: points (distance from the axis, y, the normal's two
components in the same plane, v), from the top to the bottom.
"""

import math

from .linear import inverse, mapped, transposed
from .shapes import Mesh, add


def revolve(profile, n, axes=(1, 1, 1), uv_at=None):
    """The profile is of a surface that is round, which `axes` then stretch. u is the angle around y
    of the result, 0 and 1 at -z and 0.5 at +z."""
    rows = len(profile) - 1
    a, b, c = axes

    def point_at(u, t):
        radius, y, normal_out, normal_up, v = profile[round(t * rows)]
        if radius == 0:  # the tip of one triangle, in the middle of its base
            u = min(max(u + (0.5 if t < 0.5 else -0.5) / n, 0), 1)
        angle = 2 * math.pi * (u - 0.5)
        x, z = math.sin(angle) / a, math.cos(angle) / c
        size = math.hypot(x, z)
        x, z = x / size, z / size
        position = (a * radius * x, b * y, c * radius * z)
        normal = (normal_out * x / a, normal_up / b, normal_out * z / c)
        return position, normal, uv_at(position) if uv_at else (u, v)

    return Mesh().add_sheet(point_at, n, rows)


def cap(y, radius, n, top, hole=0.0, axes=(1, 1, 1)):
    """The flat end of a round surface, or a disk; the image covers the square around it."""
    up = 1 if top else -1

    def uv_at(p):
        u, v = p[0] / (2 * radius * axes[0]), p[2] / (2 * radius * axes[2])
        return (0.5 + u, 0.5 + up * v)

    ends = [(hole, y, 0, up, 0), (radius, y, 0, up, 0)]
    return revolve(ends if top else ends[::-1], n, axes, uv_at)


def arc(y, radius, start, end, steps):
    """Of a circle around (0, y); angles from the pole at the top."""
    points = []
    for i in range(steps + 1):
        angle = start + (end - start) * i / steps
        out = 0.0 if angle in (0.0, math.pi) else math.sin(angle)
        points.append((radius * out, y + radius * math.cos(angle), out, math.cos(angle),
                       angle / math.pi))
    return points


def with_height_as_v(profile, low, high):
    return [(*point[:4], (high - point[1]) / (high - low)) for point in profile]


def sphere(radius, n):
    return revolve(arc(0, radius, 0.0, math.pi, n // 2), n)


def cylinder(height, bottom, top, n):
    """KHR_implicit_shapes's, with two radii."""
    steps = max(n // 6, 1)
    slope = (top - bottom) / height
    side = [(top + (bottom - top) * i / steps, height * (0.5 - i / steps), 1, -slope, i / steps)
            for i in range(steps + 1)]
    mesh = revolve(side, n)
    if top > 0:
        mesh.append(cap(height / 2, top, n, True))
    if bottom > 0:
        mesh.append(cap(-height / 2, bottom, n, False))
    return mesh


def capsule(height, bottom, top, n):
    """Two spheres and the cone that touches both where its normal is theirs."""
    touch = math.acos((bottom - top) / height)
    profile = (arc(height / 2, top, 0.0, touch, n // 4) +
               arc(-height / 2, bottom, touch, math.pi, n // 4))
    return revolve(with_height_as_v(profile, -height / 2 - bottom, height / 2 + top), n)


def plane(width, depth):
    return Mesh().add_sheet(lambda u, v: (
        (width * (u - 0.5), 0, depth * (v - 0.5)), (0, 1, 0), (u, v)), 1, 1)


def box(size):
    mesh = Mesh()
    # For each face its axis and side, and the image's direction to the right and down.
    for axis, side, right, right_sign, down, down_sign in (
            (0, -1, 2, 1, 1, -1), (0, 1, 2, -1, 1, -1), (1, -1, 0, 1, 2, -1),
            (1, 1, 0, 1, 2, 1), (2, -1, 0, -1, 1, -1), (2, 1, 0, 1, 1, -1)):
        def point_at(u, v):
            position, normal = [0, 0, 0], [0, 0, 0]
            position[axis], normal[axis] = side * size[axis] / 2, side
            position[right] = right_sign * size[right] * (u - 0.5)
            position[down] = down_sign * size[down] * (v - 0.5)
            return position, normal, (u, v)
        mesh.add_sheet(point_at, 1, 1)
    return mesh


def torus(major, minor, n):
    """v goes once around the tube, from its top over the outside."""
    def point_at(u, v):
        around, about = 2 * math.pi * (u - 0.5), 2 * math.pi * v
        normal = (math.sin(around) * math.sin(about), math.cos(about),
                  math.cos(around) * math.sin(about))
        return ((major * math.sin(around) + minor * normal[0], minor * normal[1],
                 major * math.cos(around) + minor * normal[2]), normal, (u, v))

    return Mesh().add_sheet(point_at, n, n // 2)


def quadric(axes, profile_at, n, low=-1.0, high=1.0, caps=()):
    """A form of LUME_quadric. profile_at(t), t from 0 at the top to 1 at the bottom, gives distance
    and height on the round surface that `axes` stretch, and the gradient there. `caps`: heights and
    whether they face up, with the radius."""
    profile = [(*profile_at(i / (n // 2)), 0) for i in range(n // 2 + 1)]
    mesh = revolve(with_height_as_v(profile, low, high), n, axes)
    for y, radius, top in caps:
        mesh.append(cap(y, radius, n, top, axes=axes))
    return mesh


def affine_sphere(matrix, offset, n):
    """The unit sphere under an affine map."""
    ball, mesh = sphere(1.0, n), Mesh()
    for_normals = transposed(inverse(matrix))
    for p, normal, uv in zip(ball.positions, ball.normals, ball.uvs):
        mesh.add_vertex(add(mapped(matrix, p), offset), mapped(for_normals, normal), uv)
    mesh.triangles = ball.triangles
    return mesh


def graph(height_at, slope_at, width, depth, steps):
    """y = height_at(x, z) over a rectangle around the origin, from above."""
    def point_at(u, v):
        x, z = width * (u - 0.5), depth * (v - 0.5)
        dx, dz = slope_at(x, z)
        return (x, height_at(x, z), z), (-dx, 1, -dz), (u, v)

    return Mesh().add_sheet(point_at, steps, steps)


def ring_polygon(outer, inner):
    """A flat ring in the plane z = 0 between two closed outlines with as many corners each, which
    wind counter-clockwise around the origin side by side."""
    mesh = Mesh()
    left, right = min(p[0] for p in outer), max(p[0] for p in outer)
    bottom, top = min(p[1] for p in outer), max(p[1] for p in outer)
    for x, y, _ in outer + inner:
        mesh.add_vertex((x, y, 0), (0, 0, 1), ((x - left) / (right - left),
                                               (top - y) / (top - bottom)))
    count = len(outer)
    for i in range(count):
        j = (i + 1) % count
        mesh.add_triangle(i, j, count + j)
        mesh.add_triangle(i, count + j, count + i)
    return mesh
