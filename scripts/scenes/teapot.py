# SPDX-License-Identifier: Apache-2.0
"""Newell's teapot in its 32 Bezier patches, on a table."""

from . import bezier, teapot_points
from .gltf import Gltf, turn
from .shapes import quad

SCALE = 0.05  # metres to the unit of the original numbers


def y_up(p):
    return (SCALE * p[0], SCALE * p[2], -SCALE * p[1])


def add_pot(scene):
    patches = [[[y_up(p) for p in row] for row in patch] for patch in teapot_points.patches()]
    # The pot has no thickness, and one sees into it beside the lid and through the spout.
    glaze = scene.material("glaze", (0.10, 0.22, 0.42), 0.12, doubleSided=True)
    primitive = scene.primitive(bezier.tessellate(patches, 8), glaze)
    shape = scene.shape("LUME_bezier_patch", **bezier.parameters(patches))
    scene.node("teapot", mesh=scene.mesh("teapot", scene.bound(primitive, shape)),
               translation=[0, 0.001, 0], rotation=turn("y", 30))


def add_table(scene):
    linen = scene.material("linen", (0.62, 0.56, 0.47), 0.9)
    table = scene.primitive(quad((-1.5, 0, 1), (3, 0, 0), (0, 0, -2)), linen)
    plane = scene.shape("plane", sizeX=3, sizeZ=2)
    scene.node("table", mesh=scene.mesh("table", scene.bound(table, plane)))
    plaster = scene.material("plaster", (0.45, 0.43, 0.42), 0.95)
    scene.place("wall", quad((-2, 0, -0.6), (4, 0, 0), (0, 1.5, 0)), plaster)


def build():
    scene = Gltf()
    add_pot(scene)
    add_table(scene)
    scene.light("lamp", "spot", (1, 0.93, 0.84), 9.0, (-0.75, 1.0, 0.65), (0.0, 0.06, 0.0),
                spot={"innerConeAngle": 0.3, "outerConeAngle": 0.55})
    scene.light("room", "point", (0.75, 0.85, 1.0), 0.7, (0.8, 0.7, 0.7))
    window = scene.material("window", (0, 0, 0), emission=(2.2, 2.4, 2.6))
    scene.place("window", quad((0.55, 0.25, 0.9), (-0.6, 0, 0.2), (0, 0.6, 0)), window)
    scene.camera("camera", (0.05, 0.33, 0.95), (0, 0.072, 0), yfov=18.5, aspect=1.5)
    return scene
