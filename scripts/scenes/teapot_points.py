# SPDX-License-Identifier: Apache-2.0
"""The numbers of Newell's teapot of 1975 (in the height that Blinn gave it): z is up, the spout
points to +x, and only what lies at y <= 0, or of the round parts in one quarter, is written down.

A patch has four rows of four control points. Rows go along the part's outline; within a row of a
round part the points go a quarter around the axis, of handle and spout halfway around the tube.
"""

# The outlines of the round parts: four rows of (distance from the axis, z) for each patch.
RIM = [(1.4, 2.4), (1.3375, 2.53125), (1.4375, 2.53125), (1.5, 2.4)]
UPPER_BODY = [(1.5, 2.4), (1.75, 1.875), (2.0, 1.35), (2.0, 0.9)]
LOWER_BODY = [(2.0, 0.9), (2.0, 0.45), (1.5, 0.225), (1.5, 0.15)]
BOTTOM = [(1.5, 0.15), (1.5, 0.075), (1.425, 0.0), (0.0, 0.0)]
KNOB = [(0.0, 3.15), (0.8, 3.15), (0.0, 2.85), (0.2, 2.7)]
LID = [(0.2, 2.7), (0.4, 2.55), (1.3, 2.55), (1.3, 2.4)]
ROUND = [RIM, UPPER_BODY, LOWER_BODY, BOTTOM, KNOB, LID]

# A quarter of a circle of radius 1 as (x, -y): not the best approximation, but the teapot's own.
QUARTER = [(1.0, 0.0), (1.0, 0.56), (0.56, 1.0), (0.0, 1.0)]
# The knob's widest row is rounder than the others.
KNOB_QUARTER = [(1.0, 0.0), (1.0, 0.5625), (0.5625, 1.0), (0.0, 1.0)]

# Tubes: rows of the inner and outer (x, z) of the half ring, and its -y in between.
HANDLE = [
    [((-1.6, 2.025), (-1.5, 2.25), 0.3), ((-2.3, 2.025), (-2.5, 2.25), 0.3),
     ((-2.7, 2.025), (-3.0, 2.25), 0.3), ((-2.7, 1.8), (-3.0, 1.8), 0.3)],
    [((-2.7, 1.8), (-3.0, 1.8), 0.3), ((-2.7, 1.575), (-3.0, 1.35), 0.3),
     ((-2.5, 1.125), (-2.65, 0.9375), 0.3), ((-2.0, 0.9), (-1.9, 0.6), 0.3)],
]
SPOUT = [
    [((1.7, 1.425), (1.7, 0.6), 0.66), ((2.6, 1.425), (3.1, 0.825), 0.66),
     ((2.3, 2.1), (2.4, 2.025), 0.25), ((2.7, 2.4), (3.3, 2.4), 0.25)],
    [((2.7, 2.4), (3.3, 2.4), 0.25), ((2.8, 2.475), (3.525, 2.49375), 0.25),
     ((2.9, 2.475), (3.45, 2.5125), 0.15), ((2.8, 2.4), (3.2, 2.4), 0.15)],
]


def round_patch(outline):
    """The quarter at x >= 0 and y <= 0, as rows of points."""
    def quarter_of(radius):
        return KNOB_QUARTER if radius == 0.8 else QUARTER

    return [[(round(radius * c, 9), round(-radius * s, 9), z)
             for c, s in reversed(quarter_of(radius))] for radius, z in outline]


def tube_patch(rows):
    """The half at y <= 0, as rows of points."""
    return [[(x1, 0.0, z1), (x1, -y, z1), (x0, -y, z0), (x0, 0.0, z0)]
            for (x0, z0), (x1, z1), y in rows]


def mirrored(patch, axis):
    """In the plane through the origin normal to an axis. Rows run backwards, so that what was the
    front of the patch is that of its mirror image."""
    def flip(p):
        return tuple(-c if i == axis and c else c for i, c in enumerate(p))

    return [[flip(p) for p in reversed(row)] for row in patch]


def patches():
    """The 32 patches as rows of points (x, y, z). All show their front to the outside if u runs
    along the rows and v from row to row; see docs/shapes.md."""
    result = []
    for outline in ROUND:
        quarter = round_patch(outline)
        half = [quarter, mirrored(quarter, 0)]
        result += half + [mirrored(patch, 1) for patch in half]
    for rows in HANDLE + SPOUT:
        half = tube_patch(rows)
        result += [half, mirrored(half, 1)]
    return result
