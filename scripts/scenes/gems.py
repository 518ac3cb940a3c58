# SPDX-License-Identifier: Apache-2.0
"""Seven cut gems on a round mirror. A ray that enters one is reflected inside time and again, so
the picture changes with each further step of the recursion.

The gems lie on facets that they could rest on. What they refract is painted on unlit panels, out
of the picture to the left, to the right and behind the camera; two luminous panels and three small
luminous balls light the scene and sparkle in the facets.
"""

import math
from dataclasses import dataclass

from . import facets
from .gltf import Gltf, turn
from .linear import gltf_matrix, mapped, product, rotation, scale
from .shapes import quad
from .solids import Solids

GAP = 2e-5  # metres between a gem and the mirror, so that they share no points


@dataclass
class Gem:
    name: str
    cut: list  # facets
    radius: float  # metres
    lies_on: tuple  # the facet that faces this direction most
    turned: float  # degrees around the vertical
    at: tuple  # x and z
    ior: float
    color: tuple  # what 5 mm of it leave of white light


def on_pavilion(angle=40.75):
    """Towards one of a brilliant's lower main facets."""
    return (math.sin(math.radians(angle)), -math.cos(math.radians(angle)), 0.0)


def gems():
    brilliant = facets.round_brilliant()
    yield Gem("diamond", brilliant, 0.0200, on_pavilion(), 112, (0.002, -0.004), 2.417,
              (0.985, 0.99, 0.995))
    yield Gem("ruby", brilliant, 0.0145, (0, 1, 0), 10, (-0.047, 0.012), 1.768,
              (0.91, 0.26, 0.29))
    steps = [(0.36, 0.26), (0.24, 0.21), (0.11, 0.12), (0.0, 0.0), (0.0, -0.07), (0.22, -0.37),
             (0.50, -0.67), (1.0, -1.06)]
    yield Gem("emerald", facets.step_cut(1.4, 0.35, steps), 0.0125, (0, -0.79, 0.62), 18,
              (0.047, 0.004), 1.578, (0.36, 0.86, 0.56))
    yield Gem("sapphire", facets.stretched(brilliant, 1, 1, 1.35), 0.0130, on_pavilion(), 118,
              (-0.040, -0.036), 1.77, (0.38, 0.53, 0.94))
    yield Gem("yellow diamond", facets.octahedron(), 0.0165, (1, 1, 1), 25, (0.036, -0.044), 2.417,
              (0.97, 0.84, 0.34))
    yield Gem("amethyst", facets.prism_with_tips(6, 1.5, 1.1), 0.0075, (0, 0, 1), 68,
              (-0.014, 0.043), 1.544, (0.85, 0.69, 0.96))
    yield Gem("topaz", brilliant, 0.0090, on_pavilion(), 128, (0.030, 0.040), 1.62,
              (0.98, 0.68, 0.36))


def add_gem(scene, gem):
    material = scene.material(gem.name, roughness=0.0, extensions={
        "KHR_materials_transmission": {"transmissionFactor": 1.0},
        "KHR_materials_ior": {"ior": gem.ior},
        "KHR_materials_volume": {"thicknessFactor": gem.radius, "attenuationDistance": 0.005,
                                 "attenuationColor": list(gem.color)}},
        phong={"ambientFactor": 0.0, "diffuseFactor": 0.0, "specularFactor": 0.9,
               "shininess": 800.0, "reflectionFactor": 1.0, "transmissionFactor": 1.0,
               "fresnel": True})
    cut = facets.outwards(gem.cut)
    pose = product(rotation("y", gem.turned), facets.lying_on(cut, gem.lies_on))
    posed = [[mapped(pose, p) for p in facet] for facet in cut]
    lowest = min(p[1] for facet in posed for p in facet)
    matrix = product(scale(gem.radius, gem.radius, gem.radius), pose)
    mesh = scene.mesh(gem.name, scene.primitive(facets.flat_mesh(cut), material))
    scene.node(gem.name, mesh=mesh, matrix=gltf_matrix(matrix, (
        gem.at[0], GAP - gem.radius * lowest, gem.at[1])))


def add_mirror(scene, solids):
    mirror = scene.material("mirror", (0.90, 0.93, 0.96), 0.0, metallic=1.0, phong={
        "ambientFactor": 0.0, "diffuseFactor": 0.02, "reflectionFactor": 0.88,
        "specularColor": [0.95, 0.98, 1.0]})
    brass = scene.material("brass", (0.88, 0.62, 0.27), 0.2, metallic=1.0, phong={
        "diffuseFactor": 0.35, "specularFactor": 0.6, "shininess": 80.0,
        "reflectionFactor": 0.35, "specularColor": [0.95, 0.75, 0.42]})
    solids.place("mirror", mirror, "LUME_disk", radius=0.085)
    solids.place("rim", brass, "LUME_torus", majorRadius=0.086, minorRadius=0.0022)
    squares = scene.checker(((0.10, 0.11, 0.13), (0.055, 0.06, 0.075)), (20, 20))
    table = scene.material("table", roughness=0.8, pbr={"baseColorTexture": squares},
                           phong={"diffuseFactor": 1.0})
    solids.place("table", table, "plane", at=(0, -0.0022, 0), sizeX=1.6, sizeZ=1.6)


def add_panels(scene):
    unlit = {"KHR_materials_unlit": {}}
    for name, color, corner, across, up in (
            ("left panel", (0.02, 0.26, 0.34), (-0.5, 0, 0.7), (0, 0, -0.8), (0, 0.5, 0)),
            ("right panel", (0.42, 0.07, 0.16), (0.5, 0, -0.1), (0, 0, 0.8), (0, 0.5, 0))):
        panel = scene.material(name, color, 1.0, extensions=unlit)
        scene.place(name, quad(corner, across, up), panel)
    squares = scene.checker(((0.75, 0.72, 0.66), (0.04, 0.05, 0.08)), (4, 2.5))
    behind = scene.material("chequered panel", roughness=1.0, extensions=unlit,
                            pbr={"baseColorTexture": squares})
    scene.place("chequered panel", quad((0.4, 0, 0.7), (-0.8, 0, 0), (0, 0.5, 0)), behind)


def add_lights(scene, solids):
    for name, emission, at, turned, size in (
            ("cool panel", (12.0, 13.5, 15.5), (-0.16, 0.34, 0.06), turn("z", 160), (0.20, 0.14)),
            ("warm panel", (15.0, 12.0, 8.5), (0.22, 0.30, 0.02), turn("z", -150), (0.10, 0.16))):
        glow = scene.material(name, (0, 0, 0), 1.0, emission=emission)
        solids.place(name, glow, "plane", at=at, turned=turned, sizeX=size[0], sizeZ=size[1])
    glow = scene.material("luminous ball", (0, 0, 0), 1.0, emission=(150.0, 144.0, 134.0))
    for at in ((0.04, 0.30, 0.16), (-0.07, 0.26, 0.24), (0.13, 0.20, 0.26)):
        solids.place("luminous ball", glow, "sphere", at=at, radius=0.007)


def build():
    scene = Gltf()
    solids = Solids(scene, 40)
    for gem in gems():
        add_gem(scene, gem)
    add_mirror(scene, solids)
    add_panels(scene)
    add_lights(scene, solids)
    scene.surroundings(ambient=(0.25, 0.27, 0.30), background=(0.11, 0.135, 0.175))
    scene.camera("camera", (0.0, 0.125, 0.30), (0, 0.005, -0.002), yfov=20, aspect=16 / 9)
    return scene
