# SPDX-License-Identifier: Apache-2.0
"""Meshes from formulas. Metres, +y up, triangles counter-clockwise as seen from outside."""

import math


class Mesh:
    """Vertices with a position, a normal, a texture coordinate and perhaps a colour each."""

    def __init__(self):
        self.positions, self.normals, self.uvs, self.colors, self.triangles = [], [], [], [], []

    def add_vertex(self, position, normal, uv):
        self.positions.append(tuple(position))
        self.normals.append(unit(normal))
        self.uvs.append(tuple(uv))
        return len(self.positions) - 1

    def add_triangle(self, a, b, c):
        """Leaves out triangles without area, as at the pole of a sphere."""
        p, q, r = (self.positions[i] for i in (a, b, c))
        normal = cross(sub(q, p), sub(r, p))
        if dot(normal, normal) > 1e-24:
            self.triangles.append((a, b, c))

    def add_sheet(self, point_at, columns, rows):
        """The surface point_at(u, v) -> (position, normal, texture coordinate) for u and v from 0
        to 1. From the front u goes to the right and v down."""
        first = len(self.positions)
        for j in range(rows + 1):
            for i in range(columns + 1):
                self.add_vertex(*point_at(i / columns, j / rows))
        _add_grid(self, rows, columns, first, downwards=True)
        return self

    def append(self, other):
        offset = len(self.positions)
        self.positions += other.positions
        self.normals += other.normals
        self.uvs += other.uvs
        self.colors += other.colors
        self.triangles += [tuple(i + offset for i in t) for t in other.triangles]
        return self

    def paint(self, color_at):
        """Gives each vertex the colour color_at(position)."""
        self.colors = [color_at(p) for p in self.positions]
        return self

    def extent(self):
        """The largest coordinate, whatever its sign."""
        return max(abs(c) for p in self.positions for c in p)

    def moved(self, offset):
        self.positions = [add(p, offset) for p in self.positions]
        return self


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def scaled(a, s):
    return tuple(x * s for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    size = math.sqrt(dot(a, a))
    return scaled(a, 1 / size)


def curve(points, steps):
    """A Catmull-Rom curve through the points, `steps` pieces between each two of them."""
    ends = [points[0], *points, points[-1]]
    result = []
    for p0, p1, p2, p3 in zip(ends, ends[1:], ends[2:], ends[3:]):
        for step in range(steps):
            t = step / steps
            result.append(tuple(
                0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t +
                       (3 * b - a - 3 * c + d) * t ** 3)
                for a, b, c, d in zip(p0, p1, p2, p3)))
    return [*result, points[-1]]


def _add_grid(mesh, rows, columns, first, downwards=False):
    """Two triangles for each cell of (rows + 1) * (columns + 1) vertices, rows upwards or not."""
    for j in range(rows):
        for i in range(columns):
            a = first + j * (columns + 1) + i
            b, c, d = a + 1, a + columns + 2, a + columns + 1
            if downwards:
                b, d = d, b
            mesh.add_triangle(a, b, c)
            mesh.add_triangle(a, c, d)


def lathe(profile, segments, creases=()):
    """Turns a profile of (radius, y), the outside to its right as it goes, around the y axis. The
    surface is smooth but at the points whose index is in `creases`."""
    mesh = Mesh()
    lengths = [0.0]
    for p, q in zip(profile, profile[1:]):
        lengths.append(lengths[-1] + math.dist(p, q))
    cuts = [0, *sorted(creases), len(profile) - 1]
    for start, end in zip(cuts, cuts[1:]):
        part = profile[start:end + 1]
        first = len(mesh.positions)
        for j, (radius, y) in enumerate(part):
            before, after = part[max(j - 1, 0)], part[min(j + 1, len(part) - 1)]
            dr, dy = after[0] - before[0], after[1] - before[1]
            v = 1 - lengths[start + j] / lengths[-1]
            for i in range(segments + 1):
                angle = 2 * math.pi * (i % segments) / segments
                s, c = math.sin(angle), math.cos(angle)
                mesh.add_vertex((radius * s, y, radius * c), (dy * s, -dr, dy * c),
                                (i / segments, v))
        _add_grid(mesh, len(part) - 1, segments, first)
    return mesh


def sphere(radius, segments=48, rings=24):
    """Stands on no ground: its centre is the origin."""
    angles = [math.pi * (j / rings - 0.5) for j in range(rings + 1)]
    profile = [(radius * math.cos(a), radius * math.sin(a)) for a in angles]
    profile[0], profile[-1] = (0.0, -radius), (0.0, radius)
    return lathe(profile, segments)


def torus(radius, tube, segments=64, rings=28):
    """Lies around the y axis, its centre in the origin."""
    angles = [2 * math.pi * (j / rings - 0.5) for j in range(rings)] + [-math.pi]
    return lathe([(radius + tube * math.cos(a), tube * math.sin(a)) for a in angles], segments)


def cylinder(radius, height, segments=48):
    """Stands on the origin."""
    return lathe([(0, 0), (radius, 0), (radius, height), (0, height)], segments, (1, 2))


def cone(radius, height, segments=48):
    return lathe([(0, 0), (radius, 0), (0, height)], segments, (1,))


def quad(corner, across, up, columns=1, rows=1, uv=(0, 0, 1, 1)):
    """A parallelogram from its lower left corner; faces cross(across, up). `uv`: left, top, right,
    bottom of the texture coordinates."""
    mesh = Mesh()
    normal = cross(across, up)
    for j in range(rows + 1):
        for i in range(columns + 1):
            s, t = i / columns, j / rows
            position = add(corner, add(scaled(across, s), scaled(up, t)))
            mesh.add_vertex(position, normal,
                            (uv[0] + (uv[2] - uv[0]) * s, uv[3] + (uv[1] - uv[3]) * t))
    _add_grid(mesh, rows, columns, 0)
    return mesh


def box(low, high):
    """Between two corners; each face has the whole texture."""
    mesh = Mesh()
    dx, dy, dz = sub(high, low)
    mesh.append(quad((low[0], low[1], high[2]), (dx, 0, 0), (0, dy, 0)))
    mesh.append(quad((high[0], low[1], low[2]), (-dx, 0, 0), (0, dy, 0)))
    mesh.append(quad(high[:1] + low[1:2] + high[2:], (0, 0, -dz), (0, dy, 0)))
    mesh.append(quad(low, (0, 0, dz), (0, dy, 0)))
    mesh.append(quad((low[0], high[1], high[2]), (dx, 0, 0), (0, 0, -dz)))
    mesh.append(quad(low, (dx, 0, 0), (0, 0, dz)))
    return mesh


def tube(path, radii, side, segments=24):
    """Sweeps a circle along the points of a path that lies in the plane normal to `side`."""
    mesh = Mesh()
    for j, (point, radius) in enumerate(zip(path, radii)):
        ahead = unit(sub(path[min(j + 1, len(path) - 1)], path[max(j - 1, 0)]))
        other = cross(side, ahead)
        for i in range(segments + 1):
            angle = 2 * math.pi * (i % segments) / segments
            normal = add(scaled(other, math.cos(angle)), scaled(side, math.sin(angle)))
            mesh.add_vertex(add(point, scaled(normal, radius)), normal,
                            (i / segments, j / (len(path) - 1)))
    _add_grid(mesh, len(path) - 1, segments, 0)
    return mesh
