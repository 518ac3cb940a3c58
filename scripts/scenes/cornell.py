# SPDX-License-Identifier: Apache-2.0
"""A box with a red and a green wall and a lamp in its ceiling (after Goral and others 1984,
"Modeling the Interaction of Light Between Diffuse Surfaces"), in proportions of its own: a mirror
sphere, a glass sphere and a tall block. Metallic-roughness materials only.
"""

from .gltf import Gltf, turn
from .shapes import quad
from .solids import Solids

X, Y, Z = (-1.6, 1.6), (0.0, 2.4), (-1.6, 1.6)


def matte(scene, name, color):
    """A boundary without a step in the index of refraction mirrors nothing."""
    return scene.material(name, color, 1.0, extensions={"KHR_materials_ior": {"ior": 1.0}})


def add_walls(scene):
    """Each faces inwards. The camera looks in through the front one from behind, where it is
    absent, but the mirror sees it."""
    width, height, depth = X[1] - X[0], Y[1] - Y[0], Z[1] - Z[0]
    white = matte(scene, "white", (0.73, 0.72, 0.69))
    red = matte(scene, "red", (0.62, 0.06, 0.05))
    green = matte(scene, "green", (0.11, 0.42, 0.12))
    for name, material, corner, across, up in (
            ("floor", white, (X[0], Y[0], Z[1]), (width, 0, 0), (0, 0, -depth)),
            ("ceiling", white, (X[0], Y[1], Z[0]), (width, 0, 0), (0, 0, depth)),
            ("back wall", white, (X[0], Y[0], Z[0]), (width, 0, 0), (0, height, 0)),
            ("front wall", white, (X[1], Y[0], Z[1]), (-width, 0, 0), (0, height, 0)),
            ("left wall", red, (X[0], Y[0], Z[1]), (0, 0, -depth), (0, height, 0)),
            ("right wall", green, (X[1], Y[0], Z[0]), (0, 0, depth), (0, height, 0))):
        scene.place(name, quad(corner, across, up), material)


def add_things(scene, solids):
    mirror = scene.material("mirror", (0.94, 0.94, 0.95), 0.0, metallic=1.0)
    glass = scene.material("glass", roughness=0.0, extensions={
        "KHR_materials_transmission": {"transmissionFactor": 1.0},
        "KHR_materials_ior": {"ior": 1.5},
        "KHR_materials_volume": {"thicknessFactor": 0.8, "attenuationDistance": 2.0,
                                 "attenuationColor": [0.75, 0.93, 0.90]}})
    block = matte(scene, "block", (0.72, 0.66, 0.52))
    solids.place("mirror sphere", mirror, "sphere", at=(-0.74, 0.46, -0.62), radius=0.46)
    solids.place("glass sphere", glass, "sphere", at=(0.16, 0.36, 0.52), radius=0.36)
    solids.place("block", block, "box", at=(0.76, 0.70, -0.66), turned=turn("y", 21),
                 size=(0.68, 1.40, 0.62))


def build():
    scene = Gltf()
    solids = Solids(scene, 40)
    add_walls(scene)
    add_things(scene, solids)
    lamp = scene.material("lamp", (0, 0, 0), 1.0, emission=(31.0, 27.0, 21.0))
    solids.place("lamp", lamp, "plane", at=(0, Y[1] - 0.01, 0.15), turned=turn("x", 180),
                 sizeX=0.9, sizeZ=0.6)
    # No light comes here that has bounced off a matte surface; this stands for it.
    scene.surroundings(ambient=(0.26, 0.235, 0.20), background=(0, 0, 0))
    scene.camera("camera", (0, 1.2, 6.3), (0, 1.2, 0), yfov=28.2, aspect=4 / 3)
    return scene
