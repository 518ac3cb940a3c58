# SPDX-License-Identifier: Apache-2.0
"""Scenes about light: cameras_and_lights, emissive, glass."""

from . import shapes
from .gltf import CLAMP, NEAREST, Gltf, turn
from .pictures import text_picture
from .shapes import quad
from .surfaces import add_stage


def cameras_and_lights():
    scene = Gltf()
    add_stage(scene)
    red = scene.material("red", (0.7, 0.12, 0.1), 0.4)
    white = scene.material("white", (0.7, 0.7, 0.68), 0.5)
    blue = scene.material("blue", (0.1, 0.25, 0.65), 0.3)
    scene.place("sphere", shapes.sphere(0.4, 40, 20), red, (-1.3, 0.4, -0.2))
    scene.place("box", shapes.box((-0.35, 0, -0.35), (0.35, 0.7, 0.35)), white, (0, 0, -0.5),
                rotation=turn("y", 30))
    scene.place("cone", shapes.cone(0.4, 0.9), blue, (1.3, 0, -0.2))
    scene.light("moon", "directional", (0.6, 0.75, 1.0), 0.9, target=(0.5, -0.8, -0.4))
    scene.light("bulb", "point", (1.0, 0.55, 0.25), 8.0, (-2.2, 1.1, 0.4), range=6.0)
    scene.light("spot", "spot", (0.9, 1.0, 0.8), 40.0, (1.3, 3.2, 1.9), (0.55, 0, 0.55),
                spot={"innerConeAngle": 0.20, "outerConeAngle": 0.32})
    scene.camera("front", (0.8, 1.9, 5.6), (0, 0.6, -0.3), yfov=30)
    scene.camera("top", (0, 4, 0), (0, 0, 0), height=4.0)
    scene.camera("low, wide angle", (-2.1, 0.35, 1.6), (0.3, 0.55, -0.6), yfov=55, aspect=16 / 9)
    return scene


def emissive():
    scene = Gltf()
    add_stage(scene, colors=((0.35,) * 3, (0.5,) * 3))
    words = text_picture(["LUME"], (1.0, 0.85, 0.6), (0.0, 0.0, 0.0), 3)
    sign = scene.material("sign", (0.02, 0.02, 0.02), 0.6, emission=(6, 6, 6), emissiveTexture={
        "index": scene.texture(words, (CLAMP, CLAMP), NEAREST)})
    width = 0.55 * len(words[0]) / len(words)
    scene.place("sign", quad((-width / 2, 0, 0), (width, 0, 0), (0, 0.55, 0)), sign,
                (0, 1.15, -1.9))
    for i, strength in enumerate((1, 2, 4)):
        glow = scene.material(f"glow, strength {strength}", (0, 0, 0), emission=(
            0.25 * strength, 0.55 * strength, 1.0 * strength))
        scene.place(f"ball, strength {strength}", shapes.sphere(0.2, 24, 12), glow,
                    (-1.75 + 0.7 * i, 0.2, 0.3))
    ring = scene.material("warm ring", (0, 0, 0), emission=(4.0, 1.6, 0.5))
    scene.place("ring", shapes.torus(0.38, 0.05, 32, 12), ring, (1.35, 0.45, -0.4),
                rotation=turn("x", 75))
    unlit = scene.material("unlit", (0.05, 0.7, 0.25), extensions={"KHR_materials_unlit": {}})
    scene.place("unlit box, lights nothing", shapes.box((-0.2, 0, -0.2), (0.2, 0.4, 0.2)), unlit,
                (1.25, 0, 0.9), rotation=turn("y", 25))
    clay = scene.material("clay", (0.6, 0.55, 0.5), 0.8)
    scene.place("clay box", shapes.box((-0.25, 0, -0.25), (0.25, 0.75, 0.25)), clay, (0.1, 0, -0.2),
                rotation=turn("y", -20))
    # A lamp with one side that glows: its back is dark.
    panel = scene.material("panel", (0.1, 0.1, 0.1), 0.8, emission=(2.2, 2.2, 2.4))
    scene.place("panel", quad((-0.9, 2.4, -0.6), (1.8, 0, 0), (0, 0, 1.2)), panel)
    scene.camera("front", (0.5, 1.7, 5.4), (0, 0.62, -0.3), yfov=30)
    return scene


def glassy(scene, name, roughness=0.0, color=(1, 1, 1), solid=True, attenuation=None, **more):
    extensions = {"KHR_materials_transmission": {"transmissionFactor": 1.0},
                  "KHR_materials_ior": {"ior": 1.5}}
    if solid:
        volume = {"thicknessFactor": 0.5}
        if attenuation:
            volume |= {"attenuationColor": list(attenuation[0]),
                       "attenuationDistance": attenuation[1]}
        extensions["KHR_materials_volume"] = volume
    return scene.material(name, color, roughness, extensions=extensions, **more)


def glass():
    scene = Gltf()
    add_stage(scene, colors=((0.22, 0.30, 0.36), (0.70, 0.68, 0.62)))
    ball = shapes.sphere(0.4, 56, 28)
    scene.place("clear ball", ball, glassy(scene, "clear glass"), (-1.45, 0.402, 0.1))
    scene.place("frosted ball", ball, glassy(scene, "frosted glass", roughness=0.35),
                (-0.45, 0.402, -0.55))
    amber = glassy(scene, "amber", attenuation=((0.95, 0.50, 0.12), 0.4))
    cube = shapes.box((-0.32, 0, -0.32), (0.32, 0.64, 0.32))
    scene.place("amber cube", cube, amber, (0.25, 0.002, 0.45), rotation=turn("y", 32))
    pane = glassy(scene, "thin pane", color=(0.75, 0.92, 0.85), solid=False, doubleSided=True)
    scene.place("thin pane", quad((-0.4, 0, 0), (0.8, 0, 0), (0, 1.1, 0)), pane, (1.3, 0.002, 0.75),
                rotation=turn("y", -25))
    # The same glass in three thicknesses: thicker is darker.
    teal = glassy(scene, "teal glass", attenuation=((0.15, 0.65, 0.65), 0.25))
    for i, depth in enumerate((0.05, 0.15, 0.40)):
        slab = shapes.box((-0.16, 0, -depth), (0.16, 0.5, 0))
        scene.place(f"teal slab of {100 * depth:.0f} cm", slab, teal,
                    (0.45 + 0.45 * i, 0.002, -1.0))
    scene.light("sun", "directional", (1, 0.95, 0.88), 2.2, target=(-0.5, -0.8, -0.55))
    sky = scene.material("sky", (0, 0, 0), emission=(1.5, 1.6, 1.7))
    scene.place("sky", quad((2.5, 0.5, 6), (-5, 0, 0), (0, 2.5, 0)), sky)
    key = scene.material("window", (0, 0, 0), emission=(3, 3, 3))
    scene.place("window", quad((-2.9, 0.6, 1.8), (0, 0, -1.2), (0, 1.2, 0)), key)
    scene.camera("front", (0.5, 1.6, 5.4), (0.1, 0.45, -0.2), yfov=28)
    return scene
