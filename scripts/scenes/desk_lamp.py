# SPDX-License-Identifier: Apache-2.0
"""Two desk lamps, a tall and a small one, look at a ball in the dark: a bow to Pixar's "Luxo Jr."
of 1986, which showed that a shape and its shadow can act. The lamps and the ball are of our own
design. Their bulbs are luminous spheres, the only lights.

A lamp stands in the origin of its own frame and faces +x; its arms move in the plane z = 0.
"""

import math
from dataclasses import dataclass

from . import shapes
from .gltf import Gltf, turn
from .linear import product, rotation
from .shapes import add, curve, scaled, sub, unit
from .solids import Solids

TABLE = (0.56, 0.45, 0.36)
AMBIENT = 0.04  # nits
MOON = (0.35, -0.8, -0.5)  # the way it shines
MOONLIGHT = (0.12, 0.16, 0.22)  # lux


@dataclass
class Figure:
    """A lamp's proportions. Directions are in degrees upwards from +x."""
    name: str
    arm: float  # length of each of its two halves
    lower: float  # direction of the half on the foot
    upper: float
    gaze: float  # where the shade points
    head: float  # size of the shade
    size: float  # of the whole: what the other lengths are to be multiplied with
    glow: float  # of the bulb, nits


def direction(degrees):
    return (math.cos(math.radians(degrees)), math.sin(math.radians(degrees)), 0.0)


def steered(degrees):
    """The rotation that turns +y in this direction."""
    return turn("z", degrees - 90)


class Lamp:
    def __init__(self, solids, materials, figure, at, facing):
        self.solids, self.materials, self.figure = solids, materials, figure
        self.paint, self.steel = materials[figure.name], materials["steel"]
        self.node = solids.scene.node(figure.name, translation=list(at),
                                      rotation=turn("y", facing), scale=[figure.size] * 3)
        shoulder = (0.0, 0.075, 0.0)
        elbow = add(shoulder, scaled(direction(figure.lower), figure.arm))
        neck = add(elbow, scaled(direction(figure.upper), figure.arm))
        self.add_foot()
        self.add_arm(shoulder, figure.lower, -1)
        self.add_arm(elbow, figure.upper, 1)
        for name, joint in (("shoulder", shoulder), ("elbow", elbow), ("neck", neck)):
            self.add_joint(name, joint)
        self.add_head(neck)

    def barrel(self, name, material, parent, y, height, bottom, top=None):
        """A cylinder around y that stands on a height, or hangs from it where its own is
        negative; it may be narrower on top."""
        self.solids.place(name, material, "cylinder", parent, (0, y + height / 2, 0),
                          height=abs(height), radiusBottom=bottom,
                          radiusTop=bottom if top is None else top)
        return y + height

    def rod(self, name, start, end, radius):
        """Between two points that have the same z."""
        dx, dy, _ = sub(end, start)
        self.solids.place(name, self.steel, "capsule", self.node, scaled(add(start, end), 0.5),
                          steered(math.degrees(math.atan2(dy, dx))),
                          height=round(math.hypot(dx, dy), 9), radiusBottom=radius,
                          radiusTop=radius)

    def add_foot(self):
        y = self.barrel("sole", self.materials["rubber"], self.node, 0.0, 0.004, 0.094)
        y = self.barrel("foot", self.paint, self.node, y, 0.018, 0.100, 0.096)
        y = self.barrel("foot's top", self.paint, self.node, y, 0.014, 0.096, 0.040)
        y = self.barrel("post", self.paint, self.node, y, 0.027, 0.017, 0.014)
        self.solids.place("fork", self.steel, "box", self.node, (0, y + 0.006, 0),
                          size=(0.016, 0.024, 0.030))

    def add_joint(self, name, at):
        across = turn("x", 90)
        self.solids.place(name, self.paint, "cylinder", self.node, at, across, height=0.040,
                          radiusBottom=0.0165, radiusTop=0.0165)
        self.solids.place("pin", self.steel, "capsule", self.node, at, across, height=0.052,
                          radiusBottom=0.006, radiusTop=0.006)

    def add_arm(self, start, degrees, side):
        """Two rods, and a spring beside them, to their left (1) or right (-1)."""
        length, along = self.figure.arm, direction(degrees)
        aside = scaled(direction(degrees + 90), 0.017 * side)
        for z in (-0.013, 0.013):
            first = add(start, (0, 0, z))
            self.rod("rod", first, add(first, scaled(along, length)), 0.0052)
        low, high = (add(start, scaled(along, part * length)) for part in (0.15, 0.72))
        for anchor in (low, high):
            self.rod("anchor", anchor, add(anchor, aside), 0.0042)
        self.rod("wire", add(low, aside), add(high, aside), 0.0016)
        coils = round(0.42 * length / 0.0052)
        tilted = product(rotation("z", degrees - 90), rotation("x", 9))
        for i in range(coils):
            at = add(add(start, aside), scaled(along, length * (0.20 + 0.42 * i / coils)))
            self.solids.place("coil", self.steel, "LUME_torus", self.node, at, tilted,
                              majorRadius=0.0072, minorRadius=0.0015)

    def add_head(self, neck):
        """Its frame has the neck's joint in the origin, and the shade opens towards -y."""
        scene, solids = self.solids.scene, self.solids
        head = scene.node("head", self.node, translation=list(neck),
                          rotation=steered(self.figure.gaze + 180), scale=[self.figure.head] * 3)
        solids.place("cap", self.paint, "capsule", head, (0, -0.030, 0), height=0.030,
                     radiusBottom=0.032, radiusTop=0.022)
        y = self.barrel("socket", self.paint, head, -0.030, -0.030, 0.0335)
        self.barrel("thread", self.steel, head, y, -0.016, 0.013)
        # The lining is a little narrower than the shade, and the rim covers both their edges.
        top, depth = y + 0.006, 0.105
        solids.place_frustum("shade", self.paint, depth, 0.090, 0.033, head, (0, top, 0))
        solids.place_frustum("lining", self.materials["lining"], depth, 0.0885, 0.0315, head,
                             (0, top, 0))
        solids.place("rim", self.paint, "LUME_torus", head, (0, top - depth, 0),
                     majorRadius=0.0893, minorRadius=0.0022)
        bulb = scene.material(f"bulb of the {self.figure.name}", (0, 0, 0), 1.0, emission=tuple(
            self.figure.glow * c for c in (1.0, 0.80, 0.52)))
        solids.place("bulb", bulb, "sphere", head, (0, -0.100, 0), radius=0.030)


def make_materials(scene):
    def phong(name, color, k_d, k_s, shininess, k_r=0.0, **fallback):
        return scene.material(name, color, doubleSided=True, **fallback, phong={
            "diffuseFactor": k_d, "specularFactor": k_s, "shininess": shininess,
            "reflectionFactor": k_r})

    return {
        "tall lamp": phong("petrol paint", (0.05, 0.26, 0.30), 0.8, 0.4, 60.0, 0.05,
                           roughness=0.3),
        "small lamp": phong("coral paint", (0.80, 0.16, 0.07), 0.8, 0.4, 60.0, 0.05,
                            roughness=0.3),
        "lining": phong("white enamel", (0.62, 0.60, 0.56), 0.9, 0.1, 20.0, roughness=0.6),
        "steel": phong("steel", (0.62, 0.63, 0.65), 0.35, 0.8, 90.0, 0.35, roughness=0.25,
                       metallic=1.0),
        "rubber": phong("rubber", (0.04, 0.04, 0.045), 0.8, 0.25, 20.0, roughness=0.6),
    }


def add_table(scene, solids):
    """It mirrors a little, not sharply. What is to be seen beyond it is as bright as the table is
    far from the lamps: it seems to have no end."""
    k_d, k_r = 0.9, 0.06
    table = scene.material("table", TABLE, 0.5, phong={
        "diffuseFactor": k_d, "specularFactor": 0.1, "shininess": 40.0, "reflectionFactor": k_r,
        "glossiness": 900.0})
    solids.place("table", table, "plane", sizeX=16.0, sizeZ=16.0)
    scene.light("moon", "directional", MOONLIGHT, 1.0, target=MOON)
    from_moon = k_d * -unit(MOON)[1] / math.pi
    background = tuple(color * (AMBIENT + from_moon * moon) / (1 - k_r)
                       for color, moon in zip(TABLE, MOONLIGHT))
    scene.surroundings(ambient=(AMBIENT,) * 3, background=background)


def add_ball(scene, solids, at, radius):
    """Ten stripes from pole to pole."""
    stripes = scene.checker(((0.93, 0.86, 0.70), (0.90, 0.52, 0.03)), (5, 0.5))
    vinyl = scene.material("vinyl", roughness=0.35, pbr={"baseColorTexture": stripes}, phong={
        "diffuseFactor": 0.85, "specularFactor": 0.35, "shininess": 70.0,
        "reflectionFactor": 0.04})
    solids.place("ball", vinyl, "sphere", at=at,
                 turned=product(rotation("x", 38), rotation("z", -30)), radius=radius)


def add_cord(scene, material, name, points):
    radius = 0.0035
    path = curve([(x, radius, z) for x, z in points], 6)
    scene.place(name, shapes.tube(path, [radius] * len(path), (0, 1, 0), 8), material)


def build():
    scene = Gltf()
    solids, materials = Solids(scene, 18), make_materials(scene)
    add_table(scene, solids)
    tall = Figure("tall lamp", arm=0.25, lower=112, upper=42, gaze=-52, head=1.0, size=1.0,
                  glow=420.0)
    small = Figure("small lamp", arm=0.17, lower=108, upper=38, gaze=-40, head=1.16, size=0.62,
                   glow=260.0)
    Lamp(solids, materials, tall, (-0.36, 0, -0.10), -14)
    Lamp(solids, materials, small, (0.30, 0, -0.06), 205)
    add_ball(scene, solids, (0.0, 0.065, 0.10), 0.065)
    add_cord(scene, materials["rubber"], "tall lamp's cord", [
        (-0.44, -0.13), (-0.56, -0.2), (-0.66, -0.12), (-0.8, -0.2), (-1.1, -0.45)])
    add_cord(scene, materials["rubber"], "small lamp's cord", [
        (0.345, -0.08), (0.43, -0.14), (0.52, -0.08), (0.62, -0.16), (0.9, -0.5)])
    scene.camera("camera", (0.10, 0.40, 1.65), (-0.03, 0.215, 0.0), yfov=24, aspect=16 / 9)
    return scene
