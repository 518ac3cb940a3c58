# SPDX-License-Identifier: Apache-2.0
"""What the museum shows: each kind of surface, under a transformation, with a mesh of its own."""

import math
from dataclasses import dataclass
from typing import Callable

from . import bezier, tessellations as mesh
from .linear import inverse, mapped, product, rotation, scale, transposed
from .polygonize import polygonize
from .shapes import Mesh, dot

SHEAR = ((1, 0.45, 0), (0, 1, 0), (0, 0.25, 1))
MIRROR = scale(-1, 1, 1)


@dataclass
class Exhibit:
    name: str  # capitals: it is written on the plinth
    kind: str
    parameters: dict
    tessellate: Callable[[int], Mesh]  # of the number of segments around
    transform: tuple
    color: tuple = (0.8, 0.8, 0.8)
    textured: bool = True
    is_open: bool = False  # seen from both sides


def simple():
    """What KHR_implicit_shapes has, and its near relatives."""
    yield Exhibit("PLANE", "plane", {"sizeX": 0.5, "sizeZ": 0.7, "doubleSided": True},
                  lambda n: mesh.plane(0.5, 0.7), product(rotation("x", 50), rotation("y", 20)),
                  is_open=True)
    yield Exhibit("DISK", "LUME_disk", {"radius": 0.3, "innerRadius": 0.1},
                  lambda n: mesh.cap(0, 0.3, n, True, 0.1),
                  product(rotation("x", 60), rotation("z", 15), scale(1, 1, 0.8)), is_open=True)
    yield Exhibit("BOX", "box", {"size": [0.4, 0.3, 0.35]}, lambda n: mesh.box((0.4, 0.3, 0.35)),
                  product(rotation("y", 30), SHEAR))
    yield Exhibit("SPHERE", "sphere", {"radius": 0.3}, lambda n: mesh.sphere(0.3, n),
                  product(rotation("z", 35), scale(1, 0.7, 0.85), rotation("y", 200)))
    yield Exhibit("CYLINDER", "cylinder",
                  {"height": 0.4, "radiusBottom": 0.2, "radiusTop": 0.2},
                  lambda n: mesh.cylinder(0.4, 0.2, 0.2, n),
                  product(rotation("z", -25), rotation("x", 25), scale(1.2, 1, 0.8)))
    yield Exhibit("FRUSTUM", "cylinder",
                  {"height": 0.45, "radiusBottom": 0.26, "radiusTop": 0.12},
                  lambda n: mesh.cylinder(0.45, 0.26, 0.12, n),
                  product(rotation("x", 20), MIRROR))
    yield Exhibit("TIP", "cylinder", {"height": 0.5, "radiusBottom": 0.25, "radiusTop": 0},
                  lambda n: mesh.cylinder(0.5, 0.25, 0.0, n), product(SHEAR, rotation("y", 60)))
    yield Exhibit("CAPSULE", "capsule", {"height": 0.35, "radiusBottom": 0.2, "radiusTop": 0.1},
                  lambda n: mesh.capsule(0.35, 0.2, 0.1, n),
                  product(rotation("z", 50), rotation("y", 90), MIRROR))


def quadrics():
    a, b, c = axes = (0.3, 0.3, 0.24)
    low, high = 0.35, 0.9  # waists

    def form(name, profile_at, transform, caps=False, shape=None, ends=(), **more):
        shape = shape or name.lower()
        parameters = {"form": shape, "semiAxes": list(axes)}
        if caps:
            parameters["caps"] = True
        if "hyperboloid" in shape:
            parameters["waist"] = more.pop("waist", low)
        clip = more.pop("clip", None)
        if clip:
            parameters["clip"] = {"y": [b * clip[0], b * clip[1]]}
        return Exhibit(name, "LUME_quadric", parameters,
                       lambda n: mesh.quadric(axes, profile_at, n, caps=ends), transform, **more)

    def ellipsoid(t):
        angle = math.pi * t
        out = 0.0 if t in (0, 1) else math.sin(angle)
        return out, math.cos(angle), out, math.cos(angle)

    def barrel(t):
        y = 0.6 - 1.1 * t
        out = math.sqrt(1 - y * y)
        return out, y, out, y

    def one_sheet(w):
        def profile_at(t):
            y = 1 - 2 * t
            out = math.sqrt(w * w + (1 - w * w) * y * y)
            return out, y, out, -(1 - w * w) * y
        return profile_at

    def paraboloid(t):
        return 1 - t, 2 * (1 - t) ** 2 - 1, 1 - t, -0.25

    both_ends = ((1, 1, True), (-1, 1, False))
    yield form("ELLIPSOID", ellipsoid, product(rotation("z", 30), rotation("y", 160)))
    yield form("BARREL", barrel, product(rotation("x", 25), scale(1, 1, 1.3)), caps=True,
               shape="ellipsoid", clip=(-0.5, 0.6), textured=False, color=(0.55, 0.33, 0.16),
               ends=((0.6, 0.8, True), (-0.5, math.sqrt(0.75), False)))
    yield form("PIPE", lambda t: (1, 1 - 2 * t, 1, 0), product(rotation("z", 65), MIRROR),
               shape="cylinder", is_open=True)
    yield form("CONE", lambda t: (t, 1 - 2 * t, 1, 0.5), product(rotation("x", -20), SHEAR),
               is_open=True)
    yield form("PARABOLOID", paraboloid, product(rotation("x", 30), scale(1, 1.1, 1)),
               is_open=True)
    yield form("ONE SHEET", one_sheet(low), rotation("z", 20), shape="hyperboloidOneSheet",
               is_open=True)
    yield form("ONE CAPPED", one_sheet(0.6), product(rotation("z", -20), scale(1, 1, -1)),
               caps=True, shape="hyperboloidOneSheet", waist=0.6, ends=both_ends)
    yield from two_sheets(axes, low, both_ends)


def two_sheets(axes, w, ends):
    def upper(t):
        out = 1 - t
        y = math.sqrt(w * w + (1 - w * w) * out * out)
        return out, y, (1 - w * w) * out, -y

    def lower(t):
        out, y, normal_out, normal_up = upper(1 - t)
        return out, -y, normal_out, -normal_up

    def tessellate(n, caps=()):
        return mesh.quadric(axes, upper, n, caps=caps).append(mesh.quadric(axes, lower, n))

    parameters = {"form": "hyperboloidTwoSheets", "semiAxes": list(axes), "waist": w}
    yield Exhibit("TWO SHEETS", "LUME_quadric", parameters, tessellate,
                  product(rotation("z", 35), scale(1, 1.1, 1)), is_open=True)
    yield Exhibit("TWO CAPPED", "LUME_quadric", {**parameters, "caps": True},
                  lambda n: tessellate(n, ends), product(rotation("x", 30), SHEAR))


def general_quadrics():
    """By their ten coefficients, the matrix Q's upper triangle row by row."""
    # y = p x^2 + 2 q x z + s z^2
    p, q, s = 2.2, 0.9, -1.8
    yield Exhibit(
        "SADDLE", "LUME_quadric",
        {"coefficients": [-p, 0, -q, 0, 0, 0, 0.5, -s, 0, 0],
         "clip": {"x": [-0.3, 0.3], "y": [-1, 1], "z": [-0.3, 0.3]}},
        lambda n: mesh.graph(lambda x, z: p * x * x + 2 * q * x * z + s * z * z,
                             lambda x, z: (2 * (p * x + q * z), 2 * (q * x + s * z)),
                             0.6, 0.6, n // 2),
        product(rotation("y", 25), rotation("x", 20)), (0.25, 0.45, 0.20), False, True)
    # The unit sphere under p -> M p + o: with A = M^-T M^-1 it is (p - o).A (p - o) = 1.
    m, o = ((0.30, 0.08, 0.05), (0, 0.22, -0.09), (0, 0, 0.25)), (0.05, 0.12, -0.04)
    a = product(transposed(inverse(m)), inverse(m))
    d = [-c for c in mapped(a, o)]
    coefficients = [a[0][0], a[0][1], a[0][2], d[0], a[1][1], a[1][2], d[1], a[2][2], d[2],
                    -dot(o, d) - 1]
    yield Exhibit("TEN NUMBERS", "LUME_quadric", {"coefficients": coefficients},
                  lambda n: mesh.affine_sphere(m, o, n), rotation("y", -40), (0.65, 0.12, 0.10),
                  False)


def others():
    corners = [(math.cos(math.pi * k / 5), math.sin(math.pi * k / 5)) for k in range(10)]
    outer = [((0.32, 0.15)[k % 2] * c, (0.32, 0.15)[k % 2] * s, 0.0)
             for k, (c, s) in enumerate(corners)]
    inner = [((0.16, 0.06)[k % 2] * c, (0.16, 0.06)[k % 2] * s, 0.0)
             for k, (c, s) in enumerate(corners)]
    yield Exhibit("POLYGON", "LUME_polygon",
                  {"outline": [list(p) for p in outer], "holes": [[list(p) for p in inner]]},
                  lambda n: mesh.ring_polygon(outer, inner),
                  product(rotation("x", -20), rotation("z", 18), MIRROR), is_open=True)
    yield Exhibit("TORUS", "LUME_torus", {"majorRadius": 0.22, "minorRadius": 0.09},
                  lambda n: mesh.torus(0.22, 0.09, n),
                  product(rotation("x", 55), scale(1.2, 0.9, 1), rotation("y", 30)))
    yield Exhibit("TANGLE", "LUME_implicit", {
        "expression": "x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8",
        "bounds": {"min": [-2.5] * 3, "max": [2.5] * 3}},
        lambda n: polygonize(
            lambda *p: sum(c ** 4 - 5 * c * c for c in p) + 11.8,
            lambda *p: tuple(4 * c ** 3 - 10 * c for c in p), (-2.5,) * 3, (2.5,) * 3, n // 2),
        product(rotation("y", 30), scale(1, 1, -0.8)), (0.75, 0.45, 0.10), False)

    def gyroid(x, y, z):
        return math.sin(x) * math.cos(y) + math.sin(y) * math.cos(z) + math.sin(z) * math.cos(x)

    def gyroid_gradient(x, y, z):
        return (math.cos(x) * math.cos(y) - math.sin(z) * math.sin(x),
                math.cos(y) * math.cos(z) - math.sin(x) * math.sin(y),
                math.cos(z) * math.cos(x) - math.sin(y) * math.sin(z))

    yield Exhibit("GYROID", "LUME_implicit", {
        "expression": "sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)",
        "bounds": {"min": [-3] * 3, "max": [3] * 3}},
        lambda n: polygonize(gyroid, gyroid_gradient, (-3,) * 3, (3,) * 3, n // 2),
        rotation("y", 25), (0.20, 0.40, 0.60), False, True)
    patches = banner()
    yield Exhibit("BEZIER", "LUME_bezier_patch", bezier.parameters(patches),
                  lambda n: bezier.tessellate(patches, n // 4),
                  product(rotation("x", 55), rotation("z", 10)), is_open=True)


def banner():
    """Two by two patches that join smoothly: the control points at a seam are in the middle between
    their neighbours."""
    def height(i, k):
        if i == 3:
            return (height(2, k) + height(4, k)) / 2
        if k == 3:
            return (height(i, 2) + height(i, 4)) / 2
        return 0.18 * math.sin(1.9 * i + 0.7) * math.cos(1.3 * k - 0.4)

    net = [[(0.1 * (i - 3), height(i, k), 0.09 * (k - 3)) for i in range(7)] for k in range(7)]
    return [[row[i:i + 4] for row in net[k:k + 4]] for k in (0, 3) for i in (0, 3)]


def exhibits():
    return [*simple(), *quadrics(), *general_quadrics(), *others()]
