# SPDX-License-Identifier: Apache-2.0
"""The picture of Whitted 1980, "An Improved Illumination Model for Shaded Display": a glass and a
mirror sphere over a chequered floor. Every surface is a shape.

Its materials come as near as the metallic-roughness model can. The sky is no part of a glTF file:
`lume render --background .3,.45,.75`.
"""

import math

from .gltf import NEAREST, Gltf
from .pictures import srgb

RED, YELLOW = (0.90, 0.10, 0.05), (0.95, 0.85, 0.10)
LIGHT = (4, 8, 5)
X, Z = (-8, 8), (-26, 6)  # how far the floor goes


def add_floor(scene):
    """Squares of one metre, red where floor(x) + floor(z) is even, as in the corner where both are
    least: it is there that the picture begins."""
    size = (X[1] - X[0], Z[1] - Z[0])
    squares = scene.texture([[srgb(RED), srgb(YELLOW)], [srgb(YELLOW), srgb(RED)]],
                            mag_filter=NEAREST)
    scene.used.add("KHR_texture_transform")
    tiling = {"KHR_texture_transform": {"scale": [size[0] / 2, size[1] / 2]}}
    floor = scene.material("checkerboard", roughness=1.0, doubleSided=True, pbr={
        "baseColorTexture": {"index": squares, "extensions": tiling}})
    plane = scene.shape("plane", sizeX=size[0], sizeZ=size[1], doubleSided=True)
    scene.place_shape("floor", plane, floor, translation=[sum(X) / 2, 0, sum(Z) / 2])


def add_spheres(scene):
    sphere = scene.shape("sphere", radius=0.8)
    glass = scene.material("glass", (0.9, 0.9, 0.9), 0.0, extensions={
        "KHR_materials_transmission": {"transmissionFactor": 1.0},
        "KHR_materials_volume": {"thicknessFactor": 1.6},
        "KHR_materials_ior": {"ior": 1.3}})
    mirror = scene.material("mirror", (0.7, 0.7, 0.73), 0.0, metallic=1.0)
    scene.place_shape("glass sphere", sphere, glass, translation=[-0.35, 1.25, 1.1])
    scene.place_shape("mirror sphere", sphere, mirror, translation=[0.75, 0.8, -0.6])


def build():
    scene = Gltf()
    add_floor(scene)
    add_spheres(scene)
    # The light of 1980 did not fade with the distance. This one does, and is as bright as that one
    # at the origin: there a white matte surface that faces it has a radiance of 1.
    scene.light("light", "point", (1, 1, 1), math.pi * sum(c * c for c in LIGHT), LIGHT)
    scene.camera("camera", (0, 1.35, 4.6), (0, 1, 0), yfov=40, aspect=4 / 3)
    return scene
