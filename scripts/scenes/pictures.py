# SPDX-License-Identifier: Apache-2.0
"""Procedural pictures and the PNG files that hold them.

A picture is a list of rows, row 0 at the top; a pixel is a tuple of floats 0..1, which are stored
as they are (so colours are given in sRGB). Noise is made of hashed integers: no state, no
surprises.
"""

import math
import struct
import zlib


def clamp(x, low=0.0, high=1.0):
    return min(max(x, low), high)


def mix(a, b, t):
    """Between two numbers or two tuples."""
    if isinstance(a, tuple):
        return tuple(mix(p, q, t) for p, q in zip(a, b))
    return a + (b - a) * t


def smoothstep(low, high, x):
    t = clamp((x - low) / (high - low))
    return t * t * (3 - 2 * t)


def paint(width, height, color_at):
    """The picture whose pixel at the centre (u, v), v pointing down, is color_at(u, v)."""
    return [[color_at((x + 0.5) / width, (y + 0.5) / height) for x in range(width)]
            for y in range(height)]


def srgb(color):
    """A linear colour as it is stored (IEC 61966-2-1)."""
    return tuple(12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055 for c in color)


# Noise


def random_at(*integers):
    """A number in [0, 1) for each tuple of integers (FNV-1a over them, then a final mix)."""
    h = 2166136261
    for i in integers:
        h = ((h ^ (i & 0xFFFF)) * 16777619) & 0xFFFFFFFF
    h ^= h >> 15
    h = (h * 0x2C1B3C6D) & 0xFFFFFFFF
    h ^= h >> 12
    return h / 4294967296


def value_noise(x, y, period_x, period_y, seed=0):
    """Smooth noise over a lattice of integers that repeats after the periods."""
    x0, y0 = math.floor(x), math.floor(y)
    tx, ty = smoothstep(0, 1, x - x0), smoothstep(0, 1, y - y0)

    def corner(i, j):
        return random_at((x0 + i) % period_x, (y0 + j) % period_y, seed)

    return mix(mix(corner(0, 0), corner(1, 0), tx), mix(corner(0, 1), corner(1, 1), tx), ty)


def fractal_noise(u, v, cells_x, cells_y, octaves, seed=0):
    """Octaves of value noise over the unit square, which tiles; 0..1."""
    total, weight, sum_of_weights = 0.0, 1.0, 0.0
    for octave in range(octaves):
        nx, ny = cells_x << octave, cells_y << octave
        total += weight * value_noise(u * nx, v * ny, nx, ny, seed + octave)
        sum_of_weights += weight
        weight *= 0.5
    return total / sum_of_weights


# Normal maps


def normal_map(width, height, height_at, strength):
    """The normals of a height field that tiles. Green points up the picture, as glTF has it."""
    field = [[h for h in row] for row in paint(width, height, height_at)]

    def normal(x, y):
        dx = field[y][(x + 1) % width] - field[y][x - 1]
        dy = field[y - 1][x] - field[(y + 1) % height][x]
        n = (-strength * dx, -strength * dy, 1.0)
        size = math.sqrt(sum(c * c for c in n))
        return tuple(0.5 + 0.5 * c / size for c in n)

    return [[normal(x, y) for x in range(width)] for y in range(height)]


# Letters

_FONT = {
    "A": "01110 10001 11111 10001 10001", "B": "11110 10001 11110 10001 11110",
    "C": "01111 10000 10000 10000 01111", "D": "11110 10001 10001 10001 11110",
    "E": "11111 10000 11110 10000 11111", "F": "11111 10000 11110 10000 10000",
    "G": "01111 10000 10011 10001 01111", "H": "10001 10001 11111 10001 10001",
    "I": "11111 00100 00100 00100 11111", "J": "00111 00010 00010 10010 01100",
    "K": "10010 10100 11000 10100 10010", "L": "10000 10000 10000 10000 11111",
    "M": "10001 11011 10101 10001 10001", "N": "10001 11001 10101 10011 10001",
    "O": "01110 10001 10001 10001 01110", "P": "11110 10001 11110 10000 10000",
    "Q": "01110 10001 10101 10010 01101", "R": "11110 10001 11110 10010 10001",
    "S": "01111 10000 01110 00001 11110", "T": "11111 00100 00100 00100 00100",
    "U": "10001 10001 10001 10001 01110", "V": "10001 10001 10001 01010 00100",
    "W": "10001 10001 10101 11011 10001", "X": "10001 01010 00100 01010 10001",
    "Y": "10001 01010 00100 00100 00100", "Z": "11111 00010 00100 01000 11111",
    "0": "01110 10011 10101 11001 01110", "1": "00100 01100 00100 00100 01110",
    "2": "11110 00001 01110 10000 11111", "3": "11110 00001 00110 00001 11110",
    "4": "10010 10010 11111 00010 00010", " ": "00000 00000 00000 00000 00000",
}


def text_picture(lines, ink, paper, scale=4):
    """Lines of capital letters, each padded with spaces to the longest one."""
    columns = max(len(line) for line in lines)

    def pixel(x, y):
        column, row = x // scale - 1, y // scale - 1
        letter, line = column // 6, row // 6
        if min(column, row) < 0 or letter >= columns or line >= len(lines):
            return paper
        if column % 6 == 5 or row % 6 == 5:
            return paper
        glyph = _FONT[lines[line].ljust(columns)[letter]].split()
        return ink if glyph[row % 6][column % 6] == "1" else paper

    return [[pixel(x, y) for x in range((6 * columns + 1) * scale)]
            for y in range((6 * len(lines) + 1) * scale)]


# PNG (W3C recommendation, third edition)


def _paeth(a, b, c):
    p = a + b - c
    pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
    if pa <= pb and pa <= pc:
        return a
    return b if pb <= pc else c


def _filtered(row, above, step):
    """The row with the filter in front whose bytes are nearest to zero (section 12.7)."""
    candidates = []
    for kind in range(5):
        line = bytearray([kind])
        for i, x in enumerate(row):
            a = row[i - step] if i >= step else 0
            b = above[i]
            c = above[i - step] if i >= step else 0
            guess = (0, a, b, (a + b) // 2, _paeth(a, b, c))[kind]
            line.append((x - guess) & 255)
        candidates.append(line)
    return min(candidates, key=lambda line: sum(min(x, 256 - x) for x in line[1:]))


def png(picture):
    """The bytes of a PNG file: grey, grey and alpha, RGB or RGBA by the length of the pixels."""
    height, width, channels = len(picture), len(picture[0]), len(picture[0][0])
    above = bytes(width * channels)
    lines = bytearray()
    for pixels in picture:
        row = bytes(int(clamp(c) * 255 + 0.5) for pixel in pixels for c in pixel)
        lines += _filtered(row, above, channels)
        above = row

    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))

    color_type = {1: 0, 2: 4, 3: 2, 4: 6}[channels]
    header = struct.pack(">IIBBBBB", width, height, 8, color_type, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
            chunk(b"IDAT", zlib.compress(bytes(lines), 9)) + chunk(b"IEND", b""))
