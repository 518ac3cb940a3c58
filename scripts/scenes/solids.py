# SPDX-License-Identifier: Apache-2.0
"""Shapes with the meshes that stand for them in viewers that do not know LUME_shape. Equal ones
are in the file once."""

from . import tessellations
from .linear import gltf_matrix

_MESHES = {
    "box": lambda n, size: tessellations.box(size),
    "capsule": lambda n, height, radiusBottom, radiusTop: tessellations.capsule(
        height, radiusBottom, radiusTop, n),
    "cylinder": lambda n, height, radiusBottom, radiusTop: tessellations.cylinder(
        height, radiusBottom, radiusTop, n),
    "LUME_disk": lambda n, radius: tessellations.cap(0, radius, n, True),
    "LUME_torus": lambda n, majorRadius, minorRadius: tessellations.torus(
        majorRadius, minorRadius, n),
    "plane": lambda n, sizeX, sizeZ: tessellations.plane(sizeX, sizeZ),
    "sphere": lambda n, radius: tessellations.sphere(radius, n),
}


class Solids:
    """`segments`: around, of the meshes."""

    def __init__(self, scene, segments):
        self.scene, self.segments = scene, segments
        self.primitives, self.meshes = {}, {}

    def place(self, name, material, kind, parent=None, at=(0, 0, 0), turned=None, **parameters):
        """A shape of its own node. `turned`: a quaternion or a matrix."""
        mesh = self.mesh(name, material, kind, parameters,
                         lambda: _MESHES[kind](self.segments, **parameters))
        return self.stand(name, mesh, parent, at, turned)

    def place_frustum(self, name, material, height, bottom, top, parent=None, at=(0, 0, 0)):
        """The side of a cut cone, open at both ends, from y = 0 down to y = -height. Its top is
        its smaller end."""
        half = height * bottom / (bottom - top) / 2  # of the whole cone, the tip at y = half
        low, high = -half, height - half
        axes = (bottom, half, bottom)

        def profile_at(t):
            y = (high + (low - high) * t) / half
            return ((1 - y) / 2, y, 2, 1)

        mesh = self.mesh(
            name, material, "LUME_quadric",
            {"form": "cone", "semiAxes": axes, "clip": {"y": (low, high)}},
            lambda: tessellations.quadric(axes, profile_at, self.segments, low / half,
                                          high / half))
        return self.stand(name, mesh, parent, (at[0], at[1] - high, at[2]))

    def mesh(self, name, material, kind, parameters, tessellate):
        """Of the file; equal shapes share their data."""
        textured = "Texture" in str(self.scene.json["materials"][material])
        of_shape = (kind, repr(parameters), textured)
        if of_shape not in self.primitives:
            shape = self.scene.shape(kind, **parameters)
            self.primitives[of_shape] = self.scene.bound(
                self.scene.primitive(tessellate(), material), shape)
        if (of_shape, material) not in self.meshes:
            primitive = dict(self.primitives[of_shape], material=material)
            self.meshes[of_shape, material] = self.scene.mesh(name, primitive)
        return self.meshes[of_shape, material]

    def stand(self, name, mesh, parent, at, turned=None):
        if turned and len(turned) == 3:
            return self.scene.node(name, parent, mesh=mesh, matrix=gltf_matrix(turned, at))
        rotation = {"rotation": list(turned)} if turned else {}
        return self.scene.node(name, parent, mesh=mesh, translation=list(at), **rotation)
