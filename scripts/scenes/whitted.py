# SPDX-License-Identifier: Apache-2.0
"""The picture of Whitted 1980, "An Improved Illumination Model for Shaded Display": a glass and a
mirror sphere over a chequered floor. Every surface is a shape.

The coefficients are those of the course's formula (LUME_materials_phong); the metallic-roughness
values beside them are for viewers that do not know it.
"""

import math

from .gltf import Gltf

RED, YELLOW = (0.90, 0.10, 0.05), (0.95, 0.85, 0.10)
X, Z = (-8, 8), (-26, 6)  # how far the floor goes


def add_floor(scene):
    """Squares of one metre, red where floor(x) + floor(z) is even, as in the corner where both are
    least: it is there that the texture begins."""
    size = (X[1] - X[0], Z[1] - Z[0])
    squares = scene.checker((RED, YELLOW), (size[0] / 2, size[1] / 2))
    floor = scene.material("checkerboard", roughness=1.0, doubleSided=True,
                           pbr={"baseColorTexture": squares},
                           phong={"ambientFactor": 0.1, "diffuseFactor": 0.8})
    plane = scene.shape("plane", sizeX=size[0], sizeZ=size[1], doubleSided=True)
    scene.place_shape("floor", plane, floor, translation=[sum(X) / 2, 0, sum(Z) / 2])


def add_spheres(scene):
    sphere = scene.shape("sphere", radius=0.8)
    glass = scene.material("glass", roughness=0.0, extensions={
        "KHR_materials_transmission": {"transmissionFactor": 0.9},
        "KHR_materials_volume": {"thicknessFactor": 1.6},
        "KHR_materials_ior": {"ior": 1.3}},
        phong={"ambientFactor": 0.0, "diffuseFactor": 0.05, "specularFactor": 0.8,
               "shininess": 200.0, "reflectionFactor": 0.1, "transmissionFactor": 0.9,
               "ior": 1.3})
    mirror = scene.material("mirror", (0.8, 0.8, 0.85), 0.0, metallic=1.0, phong={
        "ambientFactor": 0.05, "diffuseFactor": 0.25, "specularFactor": 0.6, "shininess": 60.0,
        "reflectionFactor": 0.65})
    scene.place_shape("glass sphere", sphere, glass, translation=[-0.35, 1.25, 1.1])
    scene.place_shape("mirror sphere", sphere, mirror, translation=[0.75, 0.8, -0.6])


def build():
    scene = Gltf()
    add_floor(scene)
    add_spheres(scene)
    # The light of 1980 does not fade with the distance: a white matte surface that faces it has a
    # radiance of 1 wherever it is.
    scene.light("light", "point", (1, 1, 1), math.pi, (4, 8, 5), attenuation=(1, 0, 0))
    scene.surroundings(ambient=(1, 1, 1), background=(0.30, 0.45, 0.75))
    scene.camera("camera", (0, 1.35, 4.6), (0, 1, 0), yfov=40, aspect=4 / 3)
    return scene
