# SPDX-License-Identifier: Apache-2.0
"""Scenes about the forms data may have: attributes, far_away."""

import math
import struct

from . import shapes
from .gltf import FLOAT, SHORT, UBYTE, UINT, USHORT, Gltf, turn
from .pictures import text_picture
from .shapes import quad
from .surfaces import checker

POINTS, LINES, STRIP, FAN = 0, 1, 5, 6


def rainbow(t):
    return tuple(0.5 + 0.45 * math.cos(2 * math.pi * (t - k / 3)) for k in range(3))


class Shelf:
    """Puts one thing after the other on a grid of six columns."""

    def __init__(self, scene):
        self.scene, self.count = scene, 0
        self.white = scene.material("white", (0.75, 0.75, 0.73), 0.6, doubleSided=True)

    def put(self, name, *primitives, **properties):
        column, row = self.count % 6, self.count // 6
        self.count += 1
        mesh = self.scene.mesh(name, *primitives)
        self.scene.node(name, mesh=mesh, translation=[column - 2.5, 0.5 - row, 0], **properties)


def ribbon():
    """A wavy strip, two vertices at a time."""
    points = []
    for i in range(13):
        x = -0.4 + 0.8 * i / 12
        points += [(x, -0.2 + 0.12 * math.sin(9 * x), 0.1), (x, 0.2 + 0.12 * math.sin(9 * x), 0.0)]
    return points


def add_modes(scene, shelf):
    points = ribbon()
    strip = {"POSITION": scene.accessor(points, FLOAT, bounds=True),
             "COLOR_0": scene.accessor([rainbow(i / 26) for i in range(26)], FLOAT)}
    shelf.put("strip, no indices, no normals, float colours",
              {"attributes": strip, "material": shelf.white, "mode": STRIP})
    rim = [(0.4 * math.cos(a), 0.4 * math.sin(a), 0.0)
           for a in (2 * math.pi * i / 16 for i in range(17))]
    colors = [(1.0, 1.0, 1.0, 1.0)] + [(*rainbow(i / 16), 1.0) for i in range(17)]
    fan = {"POSITION": scene.accessor([(0.0, 0.0, 0.15), *rim], FLOAT, bounds=True),
           "COLOR_0": scene.accessor(colors, USHORT, normalized=True)}
    indices = scene.accessor(list(range(18)), UBYTE)
    shelf.put("fan, 8-bit indices, 16-bit colours",
              {"attributes": fan, "indices": indices, "material": shelf.white, "mode": FAN})
    skipped = {"POSITION": scene.accessor(rim, FLOAT, bounds=True)}
    box = scene.primitive(shapes.box((-0.25, -0.25, -0.1), (0.25, 0.25, 0.1)), shelf.white)
    shelf.put("box with points and lines, which are skipped", box,
              {"attributes": skipped, "material": shelf.white, "mode": POINTS},
              {"attributes": skipped, "material": shelf.white, "mode": LINES})


def add_indices(scene, shelf):
    ring = shapes.torus(0.28, 0.11, 16, 8)
    material = scene.material("teal", (0.1, 0.5, 0.5), 0.4)
    tilted = {"rotation": turn("x", 65)}
    for name, component in (("8-bit", UBYTE), ("16-bit", USHORT), ("32-bit", UINT)):
        primitive = scene.primitive(ring, material)
        flat = [i for triangle in ring.triangles for i in triangle]
        primitive["indices"] = scene.accessor(flat, component)
        shelf.put(f"torus, {name} indices", primitive, **tilted)
    corners = [ring.positions[i] for triangle in ring.triangles for i in triangle]
    shelf.put("torus, no indices, no normals: flat",
              {"attributes": {"POSITION": scene.accessor(corners, FLOAT, bounds=True)},
               "material": material}, **tilted)


def add_encodings(scene, shelf):
    """Integers, interleaving, sparse values."""
    ball = shapes.sphere(0.38, 24, 12)
    indices = scene.accessor([i for t in ball.triangles for i in t], USHORT)
    scene.required.add("KHR_mesh_quantization")
    fractions = [tuple(c / 0.38 for c in p) for p in ball.positions]
    quantized = {"POSITION": scene.accessor(fractions, SHORT, normalized=True, bounds=True),
                 "NORMAL": scene.accessor(ball.normals, 5120, normalized=True),
                 "COLOR_0": scene.accessor([rainbow(0.5 + p[1]) for p in fractions], UBYTE,
                                           normalized=True)}
    shelf.put("ball, all integers", {"attributes": quantized, "indices": indices,
                                     "material": shelf.white}, scale=[0.38] * 3)

    rows = b"".join(struct.pack("<6f", *p, *n) for p, n in zip(ball.positions, ball.normals))
    view = scene.view(rows, byteStride=24)
    count = len(ball.positions)
    position = scene._add("accessors", {
        "bufferView": view, "componentType": FLOAT, "count": count, "type": "VEC3",
        "min": [-0.38] * 3, "max": [0.38] * 3})
    normal = scene._add("accessors", {"bufferView": view, "byteOffset": 12, "componentType": FLOAT,
                                      "count": count, "type": "VEC3"})
    material = scene.material("violet", (0.35, 0.12, 0.5), 0.35)
    shelf.put("ball, interleaved", {"attributes": {"POSITION": position, "NORMAL": normal},
                                    "indices": indices, "material": material})
    add_sparse(scene, shelf)


def add_sparse(scene, shelf):
    """A flat grid of which a sparse accessor lifts the middle, and a triangle that it makes out of
    zeros."""
    grid = quad((-0.4, -0.4, 0), (0.8, 0, 0), (0, 0.8, 0), 8, 8)
    raised = [i for i, p in enumerate(grid.positions) if math.hypot(p[0], p[1]) < 0.26]
    lifted = [(*grid.positions[i][:2], 0.25) for i in raised]
    position = scene.accessor(grid.positions, FLOAT)
    scene.json["accessors"][position].update({
        "min": [-0.4, -0.4, 0.0], "max": [0.4, 0.4, 0.25],
        "sparse": sparse(scene, raised, lifted, USHORT)})
    indices = scene.accessor([i for t in grid.triangles for i in t], USHORT)
    lifted_grid = {"attributes": {"POSITION": position}, "indices": indices,
                   "material": shelf.white}

    corners = [(-0.4, -0.45, 0.12), (0.4, -0.45, 0.12), (0.0, -0.25, 0.2)]
    zeros = scene._add("accessors", {
        "componentType": FLOAT, "count": 3, "type": "VEC3", "min": [-0.4, -0.45, 0.12],
        "max": [0.4, -0.25, 0.2], "sparse": sparse(scene, [0, 1, 2], corners, UBYTE)})
    red = scene.material("red", (0.7, 0.1, 0.1), 0.5)
    shelf.put("sparse accessors", lifted_grid, {"attributes": {"POSITION": zeros}, "material": red})


def sparse(scene, indices, values, component):
    kind = {UBYTE: "B", USHORT: "H"}[component]
    return {"count": len(indices),
            "indices": {"bufferView": scene.view(struct.pack(f"<{len(indices)}{kind}", *indices)),
                        "componentType": component},
            "values": {"bufferView": scene.view(b"".join(struct.pack("<3f", *v) for v in values))}}


def add_texcoords(scene, shelf):
    """Two sets: checks along the first, letters along the second."""
    tiles = scene.texture(checker((0.25, 0.25, 0.3), (0.8, 0.8, 0.75)), mag_filter=9728)
    words = scene.texture(text_picture(["UV", "01"], (1.0, 0.8, 0.3), (0.0, 0.0, 0.0), 2),
                          mag_filter=9728)
    material = scene.material("two sets", roughness=0.8, emission=(1, 1, 1),
                              pbr={"baseColorTexture": {"index": tiles, "texCoord": 0}},
                              emissiveTexture={"index": words, "texCoord": 1})
    card = quad((-0.42, -0.42, 0), (0.84, 0, 0), (0, 0.84, 0), uv=(0, 0, 3, 3))
    primitive = scene.primitive(card, material)
    second = [(0.0, 1.0), (1.0, 1.0), (0.0, 0.0), (1.0, 0.0)]
    primitive["attributes"]["TEXCOORD_1"] = scene.accessor(second, UBYTE, normalized=True)
    shelf.put("two sets of texture coordinates", primitive)


def attributes():
    scene = Gltf()
    shelf = Shelf(scene)
    add_modes(scene, shelf)
    add_indices(scene, shelf)
    add_encodings(scene, shelf)
    add_texcoords(scene, shelf)
    # A matrix instead of translation, rotation and scale; it shears.
    card = scene.primitive(shapes.box((-0.3, -0.3, -0.1), (0.3, 0.3, 0.1)),
                           scene.material("ochre", (0.65, 0.42, 0.1), 0.5))
    scene.node("sheared by a matrix", mesh=scene.mesh("sheared by a matrix", card),
               matrix=[1, 0, 0, 0, 0.35, 1, 0, 0, 0, 0, 1, 0, 2.5, -0.5, 0, 1])
    wall = scene.material("wall", (0.2, 0.2, 0.21), 0.9)
    scene.place("wall", quad((-5, -3, -0.6), (10, 0, 0), (0, 6, 0)), wall)
    scene.light("key", "directional", (1, 0.97, 0.92), 2.6, target=(0.5, -0.6, -0.7))
    fill = scene.material("fill", (0, 0, 0), emission=(0.9, 0.95, 1.0))
    scene.place("fill", quad((3, -2.5, 5), (-6, 0, 0), (0, 5, 0)), fill)
    scene.camera("front", (0, 0, 12), (0, 0, 0), yfov=13, aspect=2.4)
    return scene


def far_away():
    """A thousand kilometres from the origin, where single precision knows only steps of 6 cm. It
    must look as if it were near: round balls on an even floor, shadows that touch."""
    scene = Gltf()
    root = scene.node("far away", translation=[1.0e6, 2.0e5, -1.0e6])

    def place(name, mesh, material, at, **properties):
        mesh = scene.mesh(name, scene.primitive(mesh, material))
        scene.node(name, root, mesh=mesh, translation=list(at), **properties)

    tiles = scene.texture(checker((0.2, 0.24, 0.28), (0.62, 0.6, 0.55)), mag_filter=9728)
    floor = scene.material("floor", roughness=0.6, pbr={"baseColorTexture": {"index": tiles}})
    place("floor", quad((-5, 0, 2), (10, 0, 0), (0, 0, -5), uv=(0, 0, 25, 12.5)), floor, (0, 0, 0))
    wall = scene.material("wall", (0.45, 0.47, 0.5), 0.9)
    place("wall", quad((-5, 0, -3), (10, 0, 0), (0, 3, 0)), wall, (0, 0, 0))
    steel = scene.material("steel", (0.75, 0.75, 0.77), 0.15, 1.0)
    place("steel ball", shapes.sphere(0.4, 48, 24), steel, (-0.5, 0.4, 0))
    orange = scene.material("orange", (0.85, 0.3, 0.05), 0.5)
    place("box", shapes.box((-0.3, 0, -0.3), (0.3, 0.6, 0.3)), orange, (0.5, 0, -0.3),
          rotation=turn("y", 35))
    place("small ball", shapes.sphere(0.12, 32, 16), orange, (0.15, 0.12, 0.45))
    scene.light("sun", "directional", (1, 0.95, 0.88), 2.6, target=(0.5, -0.8, -0.5), parent=root)
    fill = scene.material("fill", (0, 0, 0), emission=(1.2, 1.3, 1.4))
    place("fill", quad((2, 0.5, 4.5), (-4, 0, 0), (0, 2, 0)), fill, (0, 0, 0))
    scene.camera("front", (0.5, 1.3, 3.6), (0, 0.32, 0), yfov=28, parent=root)
    return scene
