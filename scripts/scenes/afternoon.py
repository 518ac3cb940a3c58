# SPDX-License-Identifier: Apache-2.0
"""A still life on a walnut table in the late sun: the first picture that Lume makes.

The sun comes through a paned window in a wall to the left, out of the picture. Shadows are filled
by two soft panels, a window to the front left and a pale ceiling, and by the lantern. The room
behind the camera is painted on unlit walls: it shows in what is polished but lights nothing, so it
costs no noise.
"""

import math

from . import shapes
from .gltf import Gltf, turn
from .pictures import (clamp, fractal_noise, mix, normal_map, paint, random_at, smoothstep)
from .shapes import curve, lathe, quad

SUN = (0.75, -0.50, -0.46)  # the way it shines


def plank_height(u, v):
    """Four planks, rounded at their edges: 0 in the gaps, 1 on top."""
    edge = abs((v * 4) % 1 - 0.5) * 2
    return 1 - smoothstep(0.955, 1.0, edge) + 0.02 * fractal_noise(u, v, 4, 64, 2, 9)


def grain(u, v):
    """Lines along the planks, bent by slow noise; each plank is another board."""
    plank = int(v * 4)
    bend = fractal_noise(u, v, 2, 8, 3, 40 + plank)
    rings = 0.5 + 0.5 * math.sin(2 * math.pi * (9 * bend + 5 * (v * 4 % 1)))
    fibre = fractal_noise(u, v, 4, 96, 2, 7)
    return 0.55 * rings * bend + 0.45 * fibre, random_at(plank, 3)


def walnut(u, v):
    line, board = grain(u, v)
    color = mix((0.33, 0.21, 0.135), (0.68, 0.475, 0.32), clamp(line * 1.15))
    color = mix(color, (0.52, 0.33, 0.20), 0.25 * board)
    return mix((0.11, 0.07, 0.05), color, clamp(plank_height(u, v)))


def walnut_finish(u, v):
    """Roughness in green: the dark lines are open pores, the rest is oiled."""
    return (1.0, 0.60 - 0.28 * clamp(grain(u, v)[0]), 0.0)


def add_room(scene):
    table = scene.material(
        "walnut", color=(1, 1, 1), roughness=1.0, metallic=1.0,
        pbr={"baseColorTexture": {"index": scene.texture(paint(228, 228, walnut))},
             "metallicRoughnessTexture": {"index": scene.texture(paint(80, 80, walnut_finish))}},
        normalTexture={"index": scene.texture(normal_map(64, 256, plank_height, 0.7))})
    scene.place("table", quad((-1.25, 0, 0.9), (2.7, 0, 0), (0, 0, -1.46), uv=(0, 0, 3, 2.43)),
                table)

    def plaster_height(u, v):
        return fractal_noise(u, v, 6, 6, 4, 21)

    plaster = scene.material(
        "plaster", color=(0.60, 0.56, 0.50), roughness=0.95,
        normalTexture={"index": scene.texture(normal_map(84, 84, plaster_height, 1.6)),
                       "scale": 0.6})
    scene.place("wall", quad((-1.25, 0, -0.56), (2.7, 0, 0), (0, 1.4, 0), uv=(0, 0, 3.9, 2)),
                plaster)

    # The wall with the window, of bars around five by three panes.
    dark = scene.material("window frame", color=(0.35, 0.32, 0.28), roughness=0.8)
    x, bars = -1.25, shapes.Mesh()
    for low, high in ((-0.9, -0.40), (-0.10, -0.06), (0.24, 0.28), (0.58, 0.62), (0.92, 0.96),
                      (1.26, 3.0)):
        bars.append(shapes.box((x - 0.03, -0.1, low), (x, 2.4, high)))
    for low, high in ((-0.1, 0.51), (0.87, 0.91), (1.23, 1.27), (1.59, 2.4)):
        bars.append(shapes.box((x - 0.03, low, -0.40), (x, high, 1.26)))
    scene.place("window wall", bars, dark)


def room_picture(u, v):
    """What is behind the camera: a dim warm wall, a door, shelves, all out of focus."""
    color = mix((0.42, 0.37, 0.33), (0.24, 0.19, 0.16), smoothstep(0.1, 0.95, v))
    door = smoothstep(0.60, 0.62, u) * (1 - smoothstep(0.74, 0.76, u)) * smoothstep(0.25, 0.28, v)
    color = mix(color, (0.62, 0.57, 0.52), 0.8 * door)
    shelf = smoothstep(0.16, 0.18, u) * (1 - smoothstep(0.42, 0.44, u)) * smoothstep(0.3, 0.32, v)
    return mix(color, (0.13, 0.09, 0.08), 0.8 * shelf)


def add_light(scene):
    scene.light("low sun", "directional", (1.0, 0.77, 0.50), 6.5, target=SUN)

    def window_pane(u, v):
        bar = max(smoothstep(0.90, 0.97, abs(u * 4 % 2 - 1)),
                  smoothstep(0.93, 0.98, abs(v * 6 % 2 - 1)))
        return mix((0.93, 0.97, 1.0), (0.12, 0.12, 0.13), bar)

    window = scene.material("window", color=(0, 0, 0), roughness=1, emission=(7.6, 7.9, 8.0),
                            emissiveTexture={"index": scene.texture(paint(32, 48, window_pane))})
    scene.place("soft window", quad((-0.42, 0.40, 1.10), (-0.26, 0, -0.26), (0, 0.46, 0)), window)
    ceiling = scene.material("ceiling", color=(0, 0, 0), roughness=1, emission=(0.52, 0.54, 0.58))
    scene.place("ceiling", quad((-0.45, 0.85, -0.50), (1.2, 0, 0), (0, 0, 0.9)), ceiling)

    unlit = {"KHR_materials_unlit": {}}
    picture = {"index": scene.texture(paint(64, 32, room_picture))}
    behind = scene.material("room", extensions=unlit, pbr={"baseColorTexture": picture})
    scene.place("room behind", quad((1.45, -0.6, 2.6), (-2.7, 0, 0), (0, 2.4, 0)), behind)
    side = scene.material("side wall", color=(0.075, 0.055, 0.042), roughness=1, extensions=unlit)
    scene.place("room side", quad((1.45, -0.6, -0.56), (0, 0, 3.16), (0, 2.4, 0)), side)


def add_vase(scene):
    profile = curve([(0.0, 0.004), (0.052, 0.002), (0.060, 0.012), (0.088, 0.085), (0.096, 0.150),
                     (0.072, 0.222),
                     (0.040, 0.262), (0.034, 0.285), (0.049, 0.312)], 3)
    rim = curve([(0.049, 0.312), (0.046, 0.315), (0.042, 0.311), (0.028, 0.284), (0.030, 0.25)], 2)
    vase = lathe(profile + rim[1:], 40)

    def glaze(position):
        y = position[1]
        band = smoothstep(0.120, 0.126, y) * (1 - smoothstep(0.196, 0.204, y))
        return mix((0.55, 0.215, 0.105), (0.74, 0.62, 0.46), band)

    clay = scene.material("clay", roughness=0.9)
    scene.place("clay vase", vase.paint(glaze), clay, (-0.285, 0, -0.20), compact=True)


def add_teapot(scene):
    red = scene.material("red glaze", color=(0.56, 0.018, 0.014), roughness=0.08, doubleSided=True)
    body = curve([(0.0, 0.006), (0.045, 0.004), (0.062, 0.014), (0.098, 0.070), (0.092, 0.112),
                  (0.060, 0.142), (0.050, 0.146)], 3)
    lid = curve([(0.050, 0.146), (0.047, 0.153), (0.030, 0.164), (0.010, 0.169), (0.008, 0.175),
                 (0.015, 0.184), (0.012, 0.195), (0.0, 0.199)], 2)
    pot = lathe(body + lid[1:], 40)
    spout = curve([(0.070, 0.052, 0), (0.118, 0.066, 0), (0.138, 0.104, 0), (0.158, 0.138, 0),
                   (0.172, 0.147, 0)], 3)
    radii = [mix(0.027, 0.0105, smoothstep(0, 0.8, i / (len(spout) - 1)))
             for i in range(len(spout))]
    pot.append(shapes.tube(spout, radii, (0, 0, 1), 14))
    handle = curve([(-0.070, 0.120, 0), (-0.125, 0.135, 0), (-0.152, 0.098, 0), (-0.126, 0.058, 0),
                    (-0.082, 0.045, 0)], 4)
    pot.append(shapes.tube(handle, [0.0095] * len(handle), (0, 0, 1), 12))
    scene.place("teapot", pot, red, (0.225, 0, -0.14), compact=True, rotation=turn("y", -24))


def add_metals(scene):
    gold = scene.material("gold", color=(1.0, 0.72, 0.29), roughness=0.04, metallic=1.0)
    scene.place("gold sphere", shapes.sphere(0.066, 48, 24), gold, (-0.085, 0.066, 0.06),
                compact=True)

    def brushed(u, v):
        return (1.0, 0.8 + 0.2 * fractal_noise(u, v, 16, 4, 2, 5), 1.0)

    copper = scene.material(
        "copper", color=(0.93, 0.50, 0.36), roughness=0.38, metallic=1.0,
        pbr={"metallicRoughnessTexture": {"index": scene.texture(paint(128, 16, brushed))}})
    scene.place("copper ring", shapes.torus(0.070, 0.019, 44, 14), copper, (0.115, 0.019, 0.150),
                compact=True)


def glass(scene, name, attenuation, distance):
    return scene.material(name, roughness=0.0, extensions={
        "KHR_materials_transmission": {"transmissionFactor": 1.0},
        "KHR_materials_ior": {"ior": 1.5},
        "KHR_materials_volume": {"thicknessFactor": 0.01, "attenuationDistance": distance,
                                 "attenuationColor": list(attenuation)}})


def add_glass(scene):
    outside = curve([(0.0, 0.002), (0.040, 0.0), (0.046, 0.008), (0.056, 0.060), (0.050, 0.105),
                     (0.024, 0.150),
                     (0.0175, 0.205), (0.029, 0.246)], 3)
    lip = curve([(0.029, 0.246), (0.0275, 0.2485), (0.0255, 0.246)], 2)
    inside = curve([(0.0255, 0.246), (0.0145, 0.205), (0.0205, 0.150), (0.045, 0.105),
                    (0.051, 0.060), (0.041, 0.016), (0.0, 0.013)], 3)
    bottle = lathe(outside + lip[1:] + inside[1:], 36)
    scene.place("glass carafe", bottle, glass(scene, "sea glass", (0.38, 0.80, 0.66), 0.012),
                (0.02, 0.0005, -0.25), compact=True)
    ball = shapes.sphere(0.024, 32, 16)
    blue = scene.primitive(ball, glass(scene, "blue glass", (0.10, 0.35, 0.85), 0.04), 0.024)
    clear = dict(blue, material=glass(scene, "clear glass", (0.9, 0.95, 0.93), 0.1))
    for name, primitive, at in (("blue marble", blue, [-0.215, 0.0241, 0.115]),
                                ("clear marble", clear, [-0.005, 0.0241, 0.215])):
        scene.node(name, mesh=scene.mesh(name, primitive), translation=at, scale=[0.024] * 3)
    


def add_lantern(scene):
    def paper(u, v):
        rib = abs(v * 22 % 2 - 1)
        glow = 1 - 0.45 * abs(2 * v - 1) ** 2
        color = mix((1.0, 0.84, 0.58), (0.88, 0.56, 0.30), smoothstep(0.55, 1.0, rib))
        return tuple(glow * c for c in color)

    # A glowing shade would be found by few of the shadow rays, which makes a first picture
    # noisy. It is only painted, and a point light over its open top does the lighting.
    lantern = scene.material(
        "paper lantern", roughness=1, extensions={"KHR_materials_unlit": {}},
        pbr={"baseColorTexture": {"index": scene.texture(paint(4, 96, paper))}})
    wood = scene.material("black wood", color=(0.03, 0.022, 0.018), roughness=0.35)
    shade = lathe(curve([(0.036, 0.014), (0.050, 0.030), (0.055, 0.075), (0.050, 0.120),
                         (0.036, 0.136)], 3), 30)
    ends = lathe([(0, 0), (0.040, 0), (0.040, 0.012), (0.035, 0.015), (0, 0.015)], 30, (1, 2, 3))
    top = lathe([(0, 0.135), (0.035, 0.135), (0.038, 0.138), (0.038, 0.146), (0.012, 0.146),
                 (0.010, 0.154), (0, 0.154)], 30, (1, 2, 3, 4, 5))
    mesh = scene.mesh("lantern", scene.primitive(shade, lantern, 0.154),
                      scene.primitive(ends.append(top), wood, 0.154))
    scene.node("lantern", mesh=mesh, translation=[0.45, 0, -0.36], scale=[0.154] * 3)
    scene.light("lantern", "point", (1.0, 0.62, 0.30), 0.12, (0.45, 0.19, -0.36))


def build():
    scene = Gltf()
    add_room(scene)
    add_vase(scene)
    add_teapot(scene)
    add_metals(scene)
    add_glass(scene)
    add_lantern(scene)
    add_light(scene)
    scene.camera("3/4 view", (0.42, 0.46, 1.50), (0.075, 0.108, -0.10), yfov=20)
    return scene
