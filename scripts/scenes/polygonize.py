# SPDX-License-Identifier: Apache-2.0
"""Meshes of implicit surfaces f(x, y, z) = 0 by marching tetrahedra (Doi and Koide 1991): each cell
of a grid is cut into six tetrahedra, and each of those by at most two triangles."""

import itertools

from .shapes import Mesh, add, cross, dot, sub

# The six ways from one corner of a cube to the opposite one, along three edges.
PATHS = list(itertools.permutations(((1, 0, 0), (0, 1, 0), (0, 0, 1))))


def root_between(f, p, fp, q, fq):
    """Where f vanishes between two points at which it has opposite signs (regula falsi with the
    Illinois rule, Dowell and Jarratt 1971)."""
    low, high, f_low, f_high = 0.0, 1.0, fp, fq
    t = 0.0
    for _ in range(60):
        t = (low * f_high - high * f_low) / (f_high - f_low)
        value = f(*(a + t * (b - a) for a, b in zip(p, q)))
        if abs(value) < 1e-13 or high - low < 1e-15:
            break
        if (value < 0) == (f_high < 0):
            high, f_high, f_low = t, value, f_low / 2
        else:
            low, f_low, f_high = t, value, f_high / 2
    return tuple(a + t * (b - a) for a, b in zip(p, q))


class Polygonizer:
    def __init__(self, f, gradient, low, high, cells):
        self.f, self.gradient, self.low, self.high, self.cells = f, gradient, low, high, cells
        self.mesh, self.on_edge, self.values = Mesh(), {}, {}

    def corner(self, index):
        return tuple(a + (b - a) * i / self.cells
                     for a, b, i in zip(self.low, self.high, index))

    def value(self, index):
        if index not in self.values:
            self.values[index] = self.f(*self.corner(index))
        return self.values[index]

    def vertex(self, a, b):
        key = (a, b) if a < b else (b, a)
        if key not in self.on_edge:
            position = root_between(self.f, self.corner(key[0]), self.value(key[0]),
                                    self.corner(key[1]), self.value(key[1]))
            self.on_edge[key] = self.mesh.add_vertex(position, self.gradient(*position), (0, 0))
        return self.on_edge[key]

    def triangle(self, a, b, c):
        """With its front where the normals are."""
        p, q, r = (self.mesh.positions[i] for i in (a, b, c))
        mean = add(add(*(self.mesh.normals[i] for i in (a, b))), self.mesh.normals[c])
        if dot(cross(sub(q, p), sub(r, p)), mean) < 0:
            b, c = c, b
        self.mesh.add_triangle(a, b, c)

    def tetrahedron(self, corners):
        inside = [c for c in corners if self.value(c) < 0]
        outside = [c for c in corners if self.value(c) >= 0]
        if len(inside) in (1, 3):
            tip, base = (inside[0], outside) if len(inside) == 1 else (outside[0], inside)
            self.triangle(*(self.vertex(tip, c) for c in base))
        elif len(inside) == 2:
            a, b, c, d = (self.vertex(inside[i], outside[j])
                          for i, j in ((0, 0), (0, 1), (1, 1), (1, 0)))
            self.triangle(a, b, c)
            self.triangle(a, c, d)

    def layer(self, i):
        """For each corner with that first index, along z within y: whether it is inside."""
        steps = [[a + (b - a) * k / self.cells for k in range(self.cells + 1)]
                 for a, b in zip(self.low, self.high)]
        x = steps[0][i]
        return [[self.f(x, y, z) < 0 for z in steps[2]] for y in steps[1]]

    def crossed_cells(self):
        """Those with corners on both sides. Nearly all of a fine grid's have not, so that this
        must be quick."""
        after = self.layer(0)
        for i in range(self.cells):
            before, after = after, self.layer(i + 1)
            for j in range(self.cells):
                lines = list(zip(before[j], before[j + 1], after[j], after[j + 1]))
                inside = [sum(corners) for corners in lines]
                for k, count in enumerate(map(sum, zip(inside, inside[1:]))):
                    if count not in (0, 8):
                        yield (i, j, k)

    def run(self):
        for cell in self.crossed_cells():
            for path in PATHS:
                corners = [cell]
                for step in path:
                    corners.append(add(corners[-1], step))
                self.tetrahedron(corners)
        return self.mesh


def polygonize(f, gradient, low, high, cells):
    """The part of f = 0 in a box, with f < 0 behind it. It has no texture coordinates."""
    return Polygonizer(f, gradient, low, high, cells).run()
