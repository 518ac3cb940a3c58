# SPDX-License-Identifier: Apache-2.0
"""The sphereflake (after Haines 1987, "A Proposal for Standard Graphics Environments"): a sphere
with nine children of a third of its size, each with nine children of its own, and so on.

Level n has (9^(n+1) - 1) / 8 spheres: 7,381 for level 4, 66,430 for 5, 597,871 for 6. They are
instances of one mesh, whose primitive is a sphere shape.
"""

import math

from . import shapes
from .gltf import Gltf
from .shapes import add, cross, scaled, unit

LIGHTS = ((4, 3, 2), (1, -4, 4), (-3, 1, 5))  # z is up, as in all of the original's numbers


def child_directions():
    """Six around the equator and three above it, 54.7 degrees from the pole."""
    ring = [math.radians(60 * k) for k in range(6)]
    cap = [math.radians(30 + 120 * k) for k in range(3)]
    low, high = math.sqrt(2 / 3), math.sqrt(1 / 3)
    return ([(math.cos(a), math.sin(a), 0.0) for a in ring] +
            [(low * math.cos(a), low * math.sin(a), high) for a in cap])


CHILDREN = child_directions()


def flake(center, radius, axis, level):
    """Yields (center, radius) of a sphere and of all that grow on it; `axis` is its pole."""
    yield center, radius
    if level == 0:
        return
    side = unit(cross(axis, (0.0, 0.0, 1.0) if abs(axis[2]) < 0.9 else (1.0, 0.0, 0.0)))
    other = cross(axis, side)
    for x, y, z in CHILDREN:
        direction = add(add(scaled(side, x), scaled(other, y)), scaled(axis, z))
        yield from flake(add(center, scaled(direction, radius * 4 / 3)), radius / 3, direction,
                         level - 1)


def y_up(p):
    return (p[0], p[2], -p[1])


def build(level=4):
    spheres = list(flake((0.0, 0.0, 0.0), 0.5, (0.0, 0.0, 1.0), level))
    scene = Gltf(file_name="sphereflake.glb" if level == 4 else f"sphereflake_{len(spheres)}.glb")
    # Half matte, half a mirror.
    pearl = scene.material("pearl", (1.0, 0.9, 0.7), 0.0, metallic=0.5, phong={
        "ambientFactor": 0.0, "diffuseFactor": 0.5, "specularFactor": 0.5, "shininess": 12.0})
    ball = scene.primitive(shapes.sphere(1.0, 12, 6), pearl)
    mesh = scene.mesh("sphere", scene.bound(ball, scene.shape("sphere", radius=1)))
    scene.place_instances("sphereflake", mesh, [y_up(center) for center, _ in spheres],
                          [radius for _, radius in spheres])
    sand = scene.material("sand", (1.0, 0.75, 0.33), 1.0, doubleSided=True,
                          phong={"ambientFactor": 0.0})
    plane = scene.shape("plane", sizeX=40, sizeZ=40, doubleSided=True)
    scene.place_shape("floor", plane, sand, translation=[0, -0.5, 0])
    for i, at in enumerate(LIGHTS):  # they do not fade with the distance
        scene.light(f"light {i + 1}", "point", (1, 1, 1), math.pi * math.sqrt(1 / 3), y_up(at),
                    attenuation=(1, 0, 0))
    scene.surroundings(background=(0.078, 0.361, 0.753))
    scene.camera("camera", y_up((2.1, 1.3, 1.7)), (0, 0, 0), yfov=45, aspect=1.0)
    return scene


def build_66430():
    return build(level=5)
