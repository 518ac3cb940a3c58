# SPDX-License-Identifier: Apache-2.0
"""Writes glTF 2.0 files that need no other file: data URIs hold buffer and images; in a .glb file
the buffer is its BIN chunk."""

import base64
import json
import math
import struct

from .pictures import png, srgb
from .shapes import cross, sub, unit

BYTE, UBYTE, SHORT, USHORT, UINT, FLOAT = 5120, 5121, 5122, 5123, 5125, 5126
_FORMATS = {BYTE: "b", UBYTE: "B", SHORT: "h", USHORT: "H", UINT: "I", FLOAT: "f"}
_MOST = {BYTE: 127, UBYTE: 255, SHORT: 32767, USHORT: 65535}
_TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}

REPEAT, MIRROR, CLAMP = 10497, 33648, 33071
NEAREST, LINEAR = 9728, 9729


def look_at(eye, target):
    """The quaternion of a camera or light at `eye` whose -z points to `target`, +y up."""
    z = unit(sub(eye, target))
    x = unit(cross((0, 1, 0), z)) if abs(z[1]) < 0.9999 else (1.0, 0.0, 0.0)
    y = cross(z, x)
    # The components are found by their squares, which keeps them accurate for every angle (Shepperd
    # 1978, "Quaternion from Rotation Matrix"), and the signs by the matrix's odd part.
    squares = (1 + x[0] - y[1] - z[2], 1 - x[0] + y[1] - z[2], 1 - x[0] - y[1] + z[2],
               1 + x[0] + y[1] + z[2])
    odd = (y[2] - z[1], z[0] - x[2], x[1] - y[0])
    i, j, k, w = (0.5 * math.sqrt(max(s, 0.0)) for s in squares)
    if w > 1e-6:
        return [math.copysign(i, odd[0]), math.copysign(j, odd[1]), math.copysign(k, odd[2]), w]
    return [i, math.copysign(j, x[1] + y[0]), math.copysign(k, x[2] + z[0]), 0.0]


def turn(axis, degrees):
    """The quaternion of a rotation around "x", "y" or "z"."""
    half = math.radians(degrees) / 2
    return [math.sin(half) if name == axis else 0.0 for name in "xyz"] + [math.cos(half)]


class Gltf:
    """A file in the making. Methods that add something return its index. `file_name` is what to
    save it as, where that is not the scene's name and .gltf."""

    def __init__(self, generator="Lume scripts/make-scenes", file_name=None):
        self.file_name = file_name
        self.json = {
            "asset": {"version": "2.0", "generator": generator,
                      "copyright": "The Lume authors, Apache-2.0"},
            "scene": 0, "scenes": [{"nodes": []}], "nodes": [],
        }
        self.data = bytearray()
        self.used = set()
        self.required = set()

    def _add(self, array, item):
        self.json.setdefault(array, []).append(item)
        return len(self.json[array]) - 1

    # Data

    def view(self, data, **more):
        self.data += bytes(-len(self.data) % 4)
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data), **more}
        self.data += data
        return self._add("bufferViews", view)

    def accessor(self, values, component, normalized=False, bounds=False, **more):
        """One element per item of `values`, a number or a tuple. Normalized ones are given as
        floats. Elements are padded to whole words, but for indices."""
        rows = [v if isinstance(v, tuple) else (v,) for v in values]
        if normalized:
            most = _MOST[component]
            rows = [tuple(int(math.floor(c * most + 0.5)) for c in row) for row in rows]
        size = struct.calcsize(_FORMATS[component]) * len(rows[0])
        padding = -size % 4 if len(rows[0]) > 1 else 0
        pack = struct.Struct("<" + _FORMATS[component] * len(rows[0]) + "x" * padding).pack
        stride = {"byteStride": size + padding} if padding else {}
        accessor = {"bufferView": self.view(b"".join(pack(*row) for row in rows), **stride),
                    "componentType": component, "count": len(rows),
                    "type": _TYPES[len(rows[0])], **more}
        if normalized:
            accessor["normalized"] = True
        if bounds:
            single = [struct.unpack("<" + "f" * len(row), struct.pack("<" + "f" * len(row), *row))
                      if component == FLOAT else row for row in rows]
            accessor["min"] = [min(c) for c in zip(*single)]
            accessor["max"] = [max(c) for c in zip(*single)]
        return self._add("accessors", accessor)

    # Surfaces

    def texture(self, picture, wrap=(REPEAT, REPEAT), mag_filter=LINEAR):
        """A texture of its own image; `picture` may be the index of an image there already is."""
        if not isinstance(picture, int):
            picture = self.image(picture)
        sampler = {"magFilter": mag_filter, "minFilter": mag_filter, "wrapS": wrap[0],
                   "wrapT": wrap[1]}
        samplers = self.json.setdefault("samplers", [])
        if sampler not in samplers:
            samplers.append(sampler)
        return self._add("textures", {"source": picture, "sampler": samplers.index(sampler)})

    def checker(self, colors, scale=(1, 1)):
        """What a material has as a texture: two linear colours in squares, 2 by 2 of them in the
        unit of u and v and so many times more. Other viewers see it as a picture."""
        self.used |= {"KHR_texture_transform", "LUME_texture_checker"}
        first, second = (srgb(color) for color in colors)
        index = self.texture([[first, second], [second, first]], mag_filter=NEAREST)
        self.json["textures"][index]["extensions"] = {
            "LUME_texture_checker": {"colors": [list(color) for color in colors]}}
        return {"index": index, "extensions": {"KHR_texture_transform": {"scale": list(scale)}}}

    def image(self, picture):
        uri = "data:image/png;base64," + base64.b64encode(png(picture)).decode()
        return self._add("images", {"uri": uri})

    def material(self, name, color=(1, 1, 1), roughness=0.5, metallic=0.0, alpha=1.0, emission=None,
                 extensions=None, pbr=None, phong=None, **more):
        """`color` is linear, `emission` in nits; `pbr` adds to pbrMetallicRoughness; `phong` has
        the coefficients that Lume takes in its place."""
        extensions = dict(extensions or {})
        if phong:
            extensions["LUME_materials_phong"] = phong
        material = {"name": name, "pbrMetallicRoughness": {
            "baseColorFactor": [*color, alpha], "metallicFactor": metallic,
            "roughnessFactor": roughness, **(pbr or {})}, **more}
        if emission:
            strength = max(max(emission), 1.0)
            material["emissiveFactor"] = [round(e / strength, 6) for e in emission]
            if strength > 1:
                extensions["KHR_materials_emissive_strength"] = {"emissiveStrength": strength}
        if extensions:
            material["extensions"] = extensions
            self.used |= set(extensions)
        return self._add("materials", material)

    def primitive(self, mesh, material, scale=None):
        """A shapes.Mesh with a material. With a scale, positions are stored as 16-bit fractions of
        it (the node must have that scale), and normals in 16 bits too: KHR_mesh_quantization."""
        if scale is None:
            attributes = {"POSITION": self.accessor(mesh.positions, FLOAT, bounds=True),
                          "NORMAL": self.accessor(mesh.normals, FLOAT)}
        else:
            self.required.add("KHR_mesh_quantization")
            fractions = [tuple(c / scale for c in p) for p in mesh.positions]
            attributes = {"POSITION": self.accessor(fractions, SHORT, normalized=True, bounds=True),
                          "NORMAL": self.accessor(mesh.normals, SHORT, normalized=True)}
        textured = "Texture" in json.dumps(self.json["materials"][material])
        if textured:
            in_unit = all(0 <= c <= 1 for uv in mesh.uvs for c in uv)
            attributes["TEXCOORD_0"] = (self.accessor(mesh.uvs, USHORT, normalized=True) if in_unit
                                        else self.accessor(mesh.uvs, FLOAT))
        if mesh.colors:
            attributes["COLOR_0"] = self.accessor(mesh.colors, UBYTE, normalized=True)
        indices = [i for triangle in mesh.triangles for i in triangle]
        width = USHORT if len(mesh.positions) <= 65535 else UINT
        return {"attributes": attributes, "indices": self.accessor(indices, width),
                "material": material}

    # Things in the scene

    def mesh(self, name, *primitives):
        return self._add("meshes", {"name": name, "primitives": list(primitives)})

    def node(self, name, parent=None, **properties):
        """A root of the scene, or a child of the node `parent`."""
        index = self._add("nodes", {"name": name, **properties})
        if parent is None:
            self.json["scenes"][0]["nodes"].append(index)
        else:
            self.json["nodes"][parent].setdefault("children", []).append(index)
        return index

    def place(self, name, mesh, material, at=(0, 0, 0), compact=False, **properties):
        """A shapes.Mesh as a node of its own; a compact one in integers."""
        if any(at):
            properties["translation"] = list(at)
        scale = mesh.extent() if compact else None
        if compact:
            properties["scale"] = [scale] * 3
        primitive = self.primitive(mesh, material, scale)
        return self.node(name, mesh=self.mesh(name, primitive), **properties)

    def camera(self, name, eye, target, yfov=None, height=None, aspect=1.5, parent=None):
        """Perspective with a vertical field of view in degrees, or orthographic with a height."""
        if height is None:
            camera = {"type": "perspective", "name": name,
                      "perspective": {"yfov": math.radians(yfov), "aspectRatio": aspect,
                                      "znear": 0.01}}
        else:
            camera = {"type": "orthographic", "name": name,
                      "orthographic": {"xmag": height * aspect / 2, "ymag": height / 2,
                                       "znear": 0.01, "zfar": 100}}
        index = self._add("cameras", camera)
        return self.node(name, parent, camera=index, translation=list(eye),
                         rotation=look_at(eye, target))

    def light(self, name, kind, color, intensity, eye=(0, 0, 0), target=(0, 0, -1), parent=None,
              attenuation=None, **more):
        """KHR_lights_punctual: candela, or lux for a directional light. `attenuation`: c1, c2 and
        c3 of 1/(c1 + c2 d + c3 d^2), which Lume takes in place of 1/d^2."""
        self.used.add("KHR_lights_punctual")
        if attenuation:
            self.used.add("LUME_materials_phong")
            more["extensions"] = {"LUME_materials_phong": {"attenuation": list(attenuation)}}
        lights = self.json.setdefault("extensions", {}).setdefault(
            "KHR_lights_punctual", {"lights": []})["lights"]
        lights.append({"name": name, "type": kind, "color": list(color), "intensity": intensity,
                       **more})
        return self.node(name, parent, translation=list(eye), rotation=look_at(eye, target),
                         extensions={"KHR_lights_punctual": {"light": len(lights) - 1}})

    def surroundings(self, **colors):
        """`ambient` light and the `background`, in nits."""
        self.used.add("LUME_materials_phong")
        self.json["scenes"][0].setdefault("extensions", {})["LUME_materials_phong"] = {
            name: list(color) for name, color in colors.items()}

    # Analytic surfaces

    def shape(self, kind, **parameters):
        """An entry of KHR_implicit_shapes; docs/shapes.md names kinds and parameters."""
        self.used |= {"KHR_implicit_shapes", "LUME_shape"}
        shapes = self.json.setdefault("extensions", {}).setdefault(
            "KHR_implicit_shapes", {"shapes": []})["shapes"]
        shapes.append({"type": kind, kind: parameters})
        return len(shapes) - 1

    def place_shape(self, name, shape, material, parent=None, **properties):
        """A node that is a shape. Viewers that do not know LUME_shape show nothing there."""
        return self.node(name, parent, extensions={"LUME_shape": {
            "shape": shape, "material": material}}, **properties)

    @staticmethod
    def bound(primitive, shape):
        """The primitive as a shape; its triangles are for viewers that do not know LUME_shape."""
        return dict(primitive, extensions={"LUME_shape": {"shape": shape}})

    def place_instances(self, name, mesh, translations, scales):
        """One node that shows a mesh once for each translation and scale."""
        self.required.add("EXT_mesh_gpu_instancing")
        attributes = {"TRANSLATION": self.accessor(translations, FLOAT),
                      "SCALE": self.accessor([(s, s, s) for s in scales], FLOAT)}
        return self.node(name, mesh=mesh, extensions={
            "EXT_mesh_gpu_instancing": {"attributes": attributes}})

    # The file

    def save(self, path):
        """Returns the number of bytes."""
        self.data += bytes(-len(self.data) % 4)
        binary = path.suffix == ".glb"
        if self.data:
            buffer = {"byteLength": len(self.data)}
            if not binary:
                buffer["uri"] = ("data:application/octet-stream;base64," +
                                 base64.b64encode(self.data).decode())
            self.json["buffers"] = [buffer]
        self.used |= self.required
        if self.used:
            self.json["extensionsUsed"] = sorted(self.used)
        if self.required:
            self.json["extensionsRequired"] = sorted(self.required)
        if binary:
            return path.write_bytes(_glb(self.json, self.data))
        text = json.dumps(_rounded(self.json), indent=0, separators=(",", ":")) + "\n"
        path.write_text(text, encoding="utf-8", newline="\n")
        return len(text)


def _glb(document, data):
    """The binary form (glTF 2.0, "GLB File Format Specification"): a header and two chunks."""
    text = json.dumps(_rounded(document), separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    chunks += struct.pack("<I4s", len(data), b"BIN\0") + bytes(data)
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def _rounded(value):
    """Floats with nine digits, which is all that single precision can hold."""
    if isinstance(value, float):
        return float(f"{value:.9g}")
    if isinstance(value, dict):
        return {key: _rounded(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_rounded(item) for item in value]
    return value
