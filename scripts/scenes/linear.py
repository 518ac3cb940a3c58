# SPDX-License-Identifier: Apache-2.0
"""Linear maps: 3x3 matrices as three rows."""

import math

from .shapes import cross, dot, scaled


def rotation(axis, degrees):
    """Around "x", "y" or "z"."""
    s, c = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
    return {"x": ((1, 0, 0), (0, c, -s), (0, s, c)),
            "y": ((c, 0, s), (0, 1, 0), (-s, 0, c)),
            "z": ((c, -s, 0), (s, c, 0), (0, 0, 1))}[axis]


def scale(x, y, z):
    return ((x, 0, 0), (0, y, 0), (0, 0, z))


def product(*matrices):
    result, *others = matrices
    for other in others:
        columns = list(zip(*other))
        result = tuple(tuple(dot(row, column) for column in columns) for row in result)
    return result


def mapped(matrix, p):
    return tuple(dot(row, p) for row in matrix)


def inverse(matrix):
    columns = list(zip(*matrix))
    rows = [cross(columns[1], columns[2]), cross(columns[2], columns[0]),
            cross(columns[0], columns[1])]
    return tuple(scaled(row, 1 / dot(columns[0], rows[0])) for row in rows)


def transposed(matrix):
    return tuple(zip(*matrix))


def gltf_matrix(matrix, offset):
    """A node's, column by column."""
    columns = [[*column, 0] for column in zip(*matrix)]
    return [c for column in [*columns, [*offset, 1]] for c in column]
