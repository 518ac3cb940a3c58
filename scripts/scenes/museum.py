# SPDX-License-Identifier: Apache-2.0
"""The museum of surfaces: every kind of shape, each under another transformation, to the left of a
mesh of itself. The shape's own fallback triangles are that same mesh, so that with
`lume render --tessellated` there are two of each.
"""

import functools
import math

from . import linear, shapes
from .exhibits import exhibits
from .gltf import CLAMP, NEAREST, Gltf
from .pictures import mix, paint, srgb, text_picture
from .shapes import quad, sub
from .surfaces import checker

COLUMNS = 6
PITCH = 1.45  # metres from one plinth to the next
ROW_DEPTH = 1.15
ROW_TOPS = (0.5, 1.1, 1.75, 2.5)  # how high the plinths are
PLINTH = (1.28, 0.68)  # width and depth
SIZE = 0.58  # of an exhibit, in its largest dimension


def grid_picture():
    """Red grows with u and green with v, in squares of an eighth, with a letter in the middle."""
    letter = text_picture(["F"], 1, 0, 1)

    def color_at(u, v):
        dark = (math.floor(8 * u) + math.floor(8 * v)) % 2
        color = mix((0.25 + 0.6 * u, 0.25 + 0.6 * v, 0.35), (0.9, 0.9, 0.88), 0.15 + 0.45 * dark)
        x, y = int((u - 0.25) * 14), int((v - 0.25) * 14)
        inside = 0 <= y < len(letter) and 0 <= x < len(letter[0])
        return (0.12, 0.12, 0.16) if inside and letter[y][x] else color

    return paint(64, 64, color_at)


class Museum:
    def __init__(self, fineness):
        self.scene, self.fineness = Gltf(file_name="museum.glb"), fineness
        self.grid = self.scene.texture(grid_picture())
        self.stone = self.scene.material("stone", (0.48, 0.47, 0.45), 0.9)

    @functools.cache
    def material(self, color, textured, is_open):
        pbr = {"baseColorTexture": {"index": self.grid}} if textured else None
        more = {"doubleSided": True} if is_open else {}
        return self.scene.material("grid" if textured else "plain", color, 0.45, pbr=pbr, **more)

    def placing(self, exhibit):
        """The exhibit's linear map, made as large as it should be, and the offset that stands the
        exhibit over the origin. They are the same whatever the fineness."""
        positions = [linear.mapped(exhibit.transform, p) for p in exhibit.tessellate(32).positions]
        low, high = ([f(p[i] for p in positions) for i in range(3)] for f in (min, max))
        factor = SIZE / max(sub(high, low))
        matrix = linear.product(linear.scale(factor, factor, factor), exhibit.transform)
        middle = [factor * (a + b) / 2 for a, b in zip(low, high)]
        # A little above the plinth: the mesh of 32 segments is smaller than what it stands for.
        return matrix, (-middle[0], 0.005 - factor * low[1], -middle[2])

    def add(self, exhibit, at):
        scene = self.scene
        plinth = scene.node(f"plinth {exhibit.name.lower()}", translation=list(at))
        material = self.material(exhibit.color, exhibit.textured, exhibit.is_open)
        triangles = scene.primitive(exhibit.tessellate(self.fineness), material)
        shape = scene.bound(triangles, scene.shape(exhibit.kind, **exhibit.parameters))
        matrix, offset = self.placing(exhibit)
        name = exhibit.name.lower()
        for x, label, primitive in ((-0.32, name, shape), (0.32, f"{name}, mesh", triangles)):
            scene.node(label, plinth, mesh=scene.mesh(label, primitive),
                       matrix=linear.gltf_matrix(matrix, (offset[0] + x, *offset[1:])))
        self.add_plinth(plinth, exhibit.name, at[1])

    def add_plinth(self, plinth, name, height):
        scene, (width, depth) = self.scene, PLINTH
        block = shapes.box((-width / 2, -height, -depth / 2), (width / 2, 0, depth / 2))
        scene.node("stone", plinth, mesh=scene.mesh("stone", scene.primitive(block, self.stone)))
        writing = text_picture([name], srgb((0.04,) * 3), srgb((0.42,) * 3), 2)
        brass = scene.material(f"label {name.lower()}", roughness=0.9, pbr={
            "baseColorTexture": {"index": scene.texture(writing, (CLAMP, CLAMP), NEAREST)}})
        size = 0.11 * len(writing[0]) / len(writing)
        label = quad((-size / 2, -0.19, depth / 2 + 0.003), (size, 0, 0), (0, 0.11, 0))
        scene.node("label", plinth, mesh=scene.mesh("label", scene.primitive(label, brass)))

    def add_hall(self):
        scene = self.scene
        tiles = scene.texture(checker(srgb((0.16,) * 3), srgb((0.24, 0.23, 0.21))),
                              mag_filter=NEAREST)
        floor = scene.material("floor", roughness=0.8, pbr={"baseColorTexture": {"index": tiles}})
        sheet = quad((-40, 0, 40), (80, 0, 0), (0, 0, -80))
        sheet.uvs = [(x, z) for x, _, z in sheet.positions]
        ground = scene.bound(scene.primitive(sheet, floor), scene.shape("plane"))  # without end
        scene.node("floor", mesh=scene.mesh("floor", ground))
        wall = scene.material("wall", (0.36, 0.40, 0.44), 0.95)
        scene.place("back wall", quad((-7, 0, -4.6), (14, 0, 0), (0, 6, 0)), wall)
        scene.place("left wall", quad((-5.6, 0, 4), (0, 0, -8.6), (0, 6, 0)), wall)
        scene.place("right wall", quad((5.6, 0, -4.6), (0, 0, 8.6), (0, 6, 0)), wall)
        scene.light("sun", "directional", (1, 0.95, 0.88), 3.7, target=(0.74, -0.60, -0.42))
        scene.light("lamp, left", "point", (0.8, 0.88, 1.0), 24.0, (-3.6, 4.8, 4.5))
        scene.light("lamp, right", "point", (1.0, 0.9, 0.8), 30.0, (4.2, 3.8, 4.0))


def build(fineness=48):
    museum = Museum(fineness)
    for i, exhibit in enumerate(exhibits()):
        row, column = divmod(i, COLUMNS)
        museum.add(exhibit, ((column - (COLUMNS - 1) / 2) * PITCH, ROW_TOPS[row],
                             -ROW_DEPTH * row))
    museum.add_hall()
    museum.scene.camera("camera", (0, 4.0, 13.0), (0, 1.45, -1.6), yfov=21, aspect=16 / 9)
    return museum.scene
