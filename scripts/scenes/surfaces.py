# SPDX-License-Identifier: Apache-2.0
"""Scenes about materials and textures: alpha_modes, materials, normal_maps, textures."""

import math

from . import shapes
from .gltf import CLAMP, LINEAR, MIRROR, NEAREST, REPEAT, Gltf, turn
from .pictures import clamp, mix, normal_map, paint, smoothstep, text_picture
from .shapes import quad


def checker(dark, light):
    return [[dark, light], [light, dark]]


def add_stage(scene, width=12.0, depth=4.0, height=4.0, colors=((0.30,) * 3, (0.42,) * 3)):
    """A chequered floor, and a wall at its far end, at z = -depth / 2."""
    tiles = scene.texture(checker(*colors), mag_filter=NEAREST)
    floor = scene.material("floor", roughness=0.9, pbr={"baseColorTexture": {"index": tiles}})
    scene.place("floor", quad((-width / 2, 0, depth), (width, 0, 0), (0, 0, -1.5 * depth),
                              uv=(0, 0, width, 1.5 * depth)), floor)
    wall = scene.material("wall", color=(0.45, 0.45, 0.47), roughness=0.95)
    scene.place("wall", quad((-width / 2, 0, -depth / 2), (width, 0, 0), (0, height, 0)), wall)


# alpha_modes


def leaf(u, v):
    """A green leaf with veins; alpha falls from 1 to 0 across its edge."""
    x, y = 2 * u - 1, 1 - v
    half_width = 0.9 * math.sin(math.pi * clamp(y)) ** 0.8 * (1 - 0.25 * y)
    inside = half_width - abs(x)
    vein = max(1 - abs(x) / 0.04, 0.6 * smoothstep(0.8, 1.0, math.cos(40 * (y - 0.45 * abs(x)))))
    color = mix((0.16, 0.42, 0.10), (0.55, 0.72, 0.30), clamp(vein))
    return (*color, clamp(0.5 + 4 * inside))


def alpha_modes():
    scene = Gltf()
    add_stage(scene)
    leaves = scene.texture(paint(96, 96, leaf), wrap=(CLAMP, CLAMP))
    texture = {"baseColorTexture": {"index": leaves}}
    modes = (("opaque", {}), ("mask", {"alphaMode": "MASK", "alphaCutoff": 0.5}),
             ("blend", {"alphaMode": "BLEND"}))
    for i, (name, mode) in enumerate(modes):
        material = scene.material(f"leaf {name}", roughness=0.7, pbr=texture, doubleSided=True,
                                  **mode)
        card = quad((-0.4, 0, 0), (0.8, 0, 0), (0, 0.9, 0))
        scene.place(f"leaf {name}", card, material, (-2.0 + 0.95 * i, 0.02, -0.9),
                    rotation=turn("y", 12))
    for i, (name, color) in enumerate((("red", (0.8, 0.1, 0.1)), ("green", (0.1, 0.7, 0.15)),
                                       ("blue", (0.1, 0.2, 0.8)))):
        pane = quad((-0.28, 0, 0), (0.56, 0, 0), (0, 0.9, 0))
        blend = scene.material(f"{name} blend", color, 0.2, alpha=0.5, alphaMode="BLEND",
                               doubleSided=True)
        scene.place(f"{name} blended pane", pane, blend, (-1.9 + 0.65 * i, 0.02, 0.55),
                    rotation=turn("y", 8))
        filtering = scene.material(f"{name} glass", color, 0.0, doubleSided=True, extensions={
            "KHR_materials_transmission": {"transmissionFactor": 1.0}})
        scene.place(f"{name} glass pane", pane, filtering, (0.45 + 0.65 * i, 0.02, 0.55),
                    rotation=turn("y", 8))
    # Both face away: the single-sided one is seen by its shadow only.
    for name, x, double in (("single-sided", 1.1, False), ("double-sided", 1.9, True)):
        paper = scene.material(f"{name} paper", (0.85, 0.55, 0.15), 0.8, doubleSided=double)
        scene.place(f"{name}, turned away", quad((0.3, 0, 0), (-0.6, 0, 0), (0, 0.8, 0)), paper,
                    (x, 0.02, -0.9))
    scene.light("sun", "directional", (1, 0.96, 0.9), 3.2, target=(-0.35, -0.75, -0.6))
    fill = scene.material("fill", (0, 0, 0), emission=(1.6, 1.7, 1.8))
    scene.place("fill", quad((2.5, 0.5, 6), (-5, 0, 0), (0, 2.5, 0)), fill)
    scene.camera("front", (0.6, 2.0, 5.2), (0.05, 0.5, -0.2), yfov=34)
    return scene


# materials


def materials():
    """No light of its own, so that it is lit by the default one or by --env."""
    scene = Gltf()
    ball = scene.primitive(shapes.sphere(0.42, 40, 20), scene.material("first"))
    rows = (("gold", (1.0, 0.77, 0.34), 1.0), ("halfway", (0.75, 0.35, 0.3), 0.5),
            ("plastic", (0.05, 0.22, 0.62), 0.0))
    for j, (name, color, metallic) in enumerate(rows):
        for i in range(6):
            material = scene.material(f"{name}, roughness {0.2 * i:.1f}", color, 0.2 * i, metallic)
            mesh = scene.mesh(f"{name} {i}", dict(ball, material=material))
            scene.node(f"{name} {i}", mesh=mesh, translation=[i - 2.5, 2.5 - j, 0])
    floor = scene.material("floor", (0.32, 0.31, 0.30), 0.6)
    scene.place("floor", quad((-6, 0, 4), (12, 0, 0), (0, 0, -6)), floor)
    wall = scene.material("wall", (0.42, 0.42, 0.43), 0.9)
    scene.place("wall", quad((-6, 0, -2), (12, 0, 0), (0, 7, 0)), wall)
    scene.camera("front", (0, 1.75, 12), (0, 1.5, 0), yfov=20)
    return scene


# normal_maps


def bumps(u, v):
    """Two by two domes and one groove along the left edge, so that a mirrored map shows."""
    x, y = (2 * u) % 1 - 0.5, (2 * v) % 1 - 0.5
    dome = math.sqrt(max(0.16 - x * x - y * y, 0.0))
    return dome - 0.1 * (1 - smoothstep(0.02, 0.04, abs(u - 0.06)))


def normal_maps():
    """Light falls from the upper left: everywhere domes must look raised and lit there."""
    scene = Gltf()
    texture = scene.texture(normal_map(128, 128, bumps, 22))
    plain = scene.material("domes", (0.55, 0.55, 0.52), 0.45, normalTexture={"index": texture})
    scene.used.add("KHR_texture_transform")
    
    quarter = {"KHR_texture_transform": {"rotation": math.pi / 2, "offset": [0, 1]}}
    turned = scene.material("domes, turned by KHR_texture_transform", (0.45, 0.55, 0.62), 0.45,
                            normalTexture={"index": texture, "extensions": quarter})
    half = scene.material("domes, scale 0.4", (0.60, 0.52, 0.45), 0.45,
                          normalTexture={"index": texture, "scale": 0.4})
    card = quad((-0.5, -0.5, 0), (1, 0, 0), (0, 1, 0))
    mirrored = quad((-0.5, -0.5, 0), (1, 0, 0), (0, 1, 0), uv=(1, 0, 0, 1))
    rotated = quad((-0.5, -0.5, 0), (1, 0, 0), (0, 1, 0))
    rotated.uvs = [(v, 1 - u) for u, v in rotated.uvs]

    top, bottom = 0.6, -0.6
    scene.place("reference", card, plain, (-1.8, top, 0))
    scene.place("turned node", card, plain, (-0.6, top, 0), rotation=turn("z", 90))
    scene.place("turned coordinates", rotated, plain, (0.6, top, 0))
    scene.place("turned by texture transform", card, turned, (1.8, top, 0))
    scene.place("mirrored coordinates", mirrored, plain, (-1.8, bottom, 0))
    scene.place("mirrored node", card, plain, (-0.6, bottom, 0), scale=[-1, 1, 1])
    primitive = scene.primitive(mirrored, plain)
    primitive["attributes"]["TANGENT"] = scene.accessor([(-1.0, 0.0, 0.0, -1.0)] * 4, 5126)
    scene.node("mirrored, tangents given", mesh=scene.mesh("mirrored, tangents given", primitive),
               translation=[0.6, bottom, 0])
    scene.place("half the height", card, half, (1.8, bottom, 0))
    wall = scene.material("wall", (0.2, 0.2, 0.21), 0.9)
    scene.place("wall", quad((-4, -3, -0.02), (8, 0, 0), (0, 6, 0)), wall)
    scene.light("upper left", "directional", (1, 1, 1), 3.0, target=(0.6, -0.6, -0.53))
    fill = scene.material("fill", (0, 0, 0), emission=(0.5, 0.5, 0.55))
    scene.place("fill", quad((2.5, -2.5, 4), (-5, 0, 0), (0, 5, 0)), fill)
    # A little off the axis, so that no ray runs exactly along the edge between two triangles.
    scene.camera("front", (0.031, 0.017, 8), (0.007, 0.003, 0), yfov=23)
    return scene


# textures


def card_picture():
    """Letters in four colours, in which every turn and flip shows."""
    rows = text_picture(["AB", "CD"], (0.95, 0.93, 0.86), None, 2)
    colors = ((0.70, 0.16, 0.12), (0.14, 0.42, 0.66), (0.18, 0.50, 0.22), (0.80, 0.52, 0.10))
    size = len(rows)

    def fill(x, y):
        return rows[y][x] or colors[2 * (2 * y >= size) + (2 * x >= size)]

    return [[fill(x, y) for x in range(size)] for y in range(size)]


def textures():
    """Cards with coordinates from -1 to 2: the picture itself is the middle ninth of each."""
    scene = Gltf()
    image = scene.image(card_picture())
    cards = (("REPEAT", (REPEAT, REPEAT), NEAREST), ("MIRROR", (MIRROR, MIRROR), NEAREST),
             ("CLAMP", (CLAMP, CLAMP), NEAREST), ("REP MIR", (REPEAT, MIRROR), NEAREST),
             ("MIR CLA", (MIRROR, CLAMP), NEAREST), ("LINEAR", (CLAMP, REPEAT), LINEAR))
    unlit = {"KHR_materials_unlit": {}}
    for i, (label, wrap, mag_filter) in enumerate(cards):
        x, y = 1.3 * (i % 3 - 1), 0.78 - 1.5 * (i // 3)
        texture = {"index": scene.texture(image, wrap, mag_filter)}
        material = scene.material(label.lower(), extensions=unlit,
                                  pbr={"baseColorTexture": texture})
        card = quad((-0.55, -0.55, 0), (1.1, 0, 0), (0, 1.1, 0), uv=(-1, -1, 2, 2))
        scene.place(label.lower(), card, material, (x, y, 0))
        writing = text_picture([label], (0.9,) * 3, (0.10, 0.10, 0.11), 2)
        paper = scene.material(f"label {label.lower()}", extensions=unlit, pbr={
            "baseColorTexture": {"index": scene.texture(writing, (CLAMP, CLAMP), NEAREST)}})
        width = 0.15 * len(writing[0]) / len(writing)
        label_card = quad((-width / 2, -0.075, 0), (width, 0, 0), (0, 0.15, 0))
        scene.place(f"label {label.lower()}", label_card, paper, (x, y - 0.65, 0))
    wall = scene.material("wall", (0.01, 0.01, 0.011), extensions=unlit)
    scene.place("wall", quad((-4, -3, -0.02), (8, 0, 0), (0, 6, 0)), wall)
    scene.camera("front", (0, 0, 5), (0, 0, 0), height=3.1, aspect=4 / 3)
    return scene
