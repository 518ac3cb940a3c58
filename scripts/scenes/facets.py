# SPDX-License-Identifier: Apache-2.0
"""Cuts of gems: convex polyhedra as lists of facets. A facet is a list of corners in one plane.
The axis of a cut is y, its table is on top, and its girdle has a radius of 1 around the origin.
Corners that facets share have the very same coordinates, so that the mesh is closed.
"""

import math

from .shapes import Mesh, add, cross, dot, scaled, sub, unit


def round_brilliant(crown=34.5, pavilion=40.75, table=0.57, girdle=0.05, star=0.5, lower=0.77):
    """The cut of 57 facets, and 16 around the girdle. Angles of the main facets in degrees; the
    table as a part of the diameter; the star facets reach so far from the table to the girdle, and
    the lower halves from the girdle to the tip, as seen along the axis."""
    up, down = math.tan(math.radians(crown)), math.tan(math.radians(pavilion))
    between = math.cos(math.pi / 8)  # main facets lie at every eighth of a turn
    star_radius = table * between + star * (1 - table * between)
    lower_radius = 1 - lower

    def ring(radius, y):
        angles = [math.pi * step / 8 for step in range(16)]
        corners = [(radius * math.cos(a), y, radius * math.sin(a)) for a in angles]
        return lambda step: corners[step % 16]

    top, edge, low_edge = ring(table, (1 - table) * up), ring(1, 0.0), ring(1, -girdle)
    above = ring(star_radius, (1 - star_radius * between) * up)
    below = ring(lower_radius, -girdle - (1 - lower_radius * between) * down)
    tip = (0.0, -girdle - down, 0.0)

    facets = [[top(k) for k in range(0, 16, 2)]]
    for k in range(0, 16, 2):
        facets += [[top(k), top(k + 2), above(k + 1)],
                   [top(k), above(k - 1), edge(k), above(k + 1)],
                   [low_edge(k), below(k - 1), tip, below(k + 1)]]
        for i in (k, k + 1):
            facets += [[edge(i), edge(i + 1), above(k + 1)],
                       [low_edge(i), low_edge(i + 1), below(k + 1)],
                       [edge(i), edge(i + 1), low_edge(i + 1), low_edge(i)]]
    return facets


def step_cut(length, corner, levels):
    """An oblong with cut corners, in steps: 1 is half its width, `length` half its length and
    `corner` what is cut from each side at the girdle. Levels from top to bottom: how far inwards of
    the girdle's outline, and y."""
    def outline(inset, y):
        x, z = length - inset, 1.0 - inset
        c = max(corner - (2 - math.sqrt(2)) * inset, 0.0)
        return [(x, y, z - c), (x - c, y, z), (c - x, y, z), (-x, y, z - c),
                (-x, y, c - z), (c - x, y, -z), (x - c, y, -z), (x, y, c - z)]

    outlines = [outline(*level) for level in levels]
    facets = [outlines[0], outlines[-1]]
    for above, below in zip(outlines, outlines[1:]):
        facets += [[above[i], above[(i + 1) % 8], below[(i + 1) % 8], below[i]] for i in range(8)]
    return facets


def octahedron():
    x, y, z = ([scaled(axis, s) for s in (1.0, -1.0)] for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
    return [[a, b, c] for a in x for b in y for c in z]


def prism_with_tips(sides, height, tip):
    """A crystal of quartz, lying or standing: two pyramids on a prism."""
    angles = [2 * math.pi * (i + 0.5) / sides for i in range(sides)]
    low, high = ([(math.sin(a), y, math.cos(a)) for a in angles] for y in (-height, height))
    facets = []
    for i in range(sides):
        j = (i + 1) % sides
        facets += [[low[i], low[j], high[j], high[i]], [high[i], high[j], (0.0, height + tip, 0.0)],
                   [low[i], low[j], (0.0, -height - tip, 0.0)]]
    return facets


def stretched(facets, x, y, z):
    return [[(x * p[0], y * p[1], z * p[2]) for p in facet] for facet in facets]


def without_repeats(facet):
    """Where an edge is a single point."""
    kept = [p for p, before in zip(facet, facet[-1:] + facet[:-1]) if p != before]
    return kept if len(kept) > 2 else []


def normal(facet):
    """Newell's, which no corner decides alone (Sutherland, Sproull, Schumacker 1974)."""
    total = (0.0, 0.0, 0.0)
    for p, q in zip(facet, facet[1:] + facet[:1]):
        total = add(total, cross(p, q))
    return total


def outwards(facets):
    """Without empty facets, the others counter-clockwise as seen from outside."""
    facets = [f for f in map(without_repeats, facets) if f]
    corners = {p for facet in facets for p in facet}
    middle = scaled(tuple(math.fsum(c) for c in zip(*corners)), 1 / len(corners))
    result = []
    for facet in facets:
        is_outwards = dot(normal([sub(p, middle) for p in facet]), sub(facet[0], middle)) > 0
        result.append(facet if is_outwards else facet[::-1])
    return result


def flat_mesh(facets):
    """Each facet has its own corners, with its normal."""
    mesh = Mesh()
    for facet in facets:
        towards = unit(normal(facet))
        first = [mesh.add_vertex(p, towards, (0.0, 0.0)) for p in facet][0]
        for i in range(1, len(facet) - 1):
            mesh.triangles.append((first, first + i, first + i + 1))
    return mesh


def lying_on(facets, direction):
    """The rotation, as a matrix, after which the facet that faces the direction most is down and
    level."""
    down = unit(max((unit(normal(f)) for f in facets), key=lambda n: dot(n, unit(direction))))
    side = unit(cross(down, (0.0, 0.0, 1.0) if abs(down[2]) < 0.9 else (1.0, 0.0, 0.0)))
    up = scaled(down, -1.0)
    return (side, up, cross(side, up))
