# SPDX-License-Identifier: Apache-2.0
"""Bicubic Bezier patches: S(u, v) = sum over i, j of B_i(u) B_j(v) P_ij, as shapes and as meshes.

A patch is four rows of four points; u runs along a row and v from row to row. Its front is the
side of dS/dv x dS/du.
"""

from .shapes import Mesh, cross, dot, sub


def bernstein(t):
    s = 1 - t
    return (s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t)


def bernstein_slope(t):
    s = 1 - t
    return (-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t)


def blend(patch, along_u, along_v):
    return tuple(sum(b * sum(a * p[axis] for a, p in zip(along_u, row))
                     for b, row in zip(along_v, patch)) for axis in range(3))


def point(patch, u, v):
    return blend(patch, bernstein(u), bernstein(v))


def normal(patch, u, v):
    """dS/dv x dS/du, of any length. Where an edge is a single point the surface has a normal all
    the same: the one next to that point."""
    du = blend(patch, bernstein_slope(u), bernstein(v))
    dv = blend(patch, bernstein(u), bernstein_slope(v))
    n = cross(dv, du)
    if dot(n, n) > 1e-16 * dot(du, du) * dot(dv, dv):
        return n
    return normal(patch, u + 1e-6 * (0.5 - u), v + 1e-6 * (0.5 - v))


def tessellate(patches, steps):
    """Texture coordinates are each patch's u and v."""
    mesh = Mesh()
    for patch in patches:
        mesh.add_sheet(lambda u, v, patch=patch: (point(patch, u, v), normal(patch, u, v), (u, v)),
                       steps, steps)
    return mesh


def parameters(patches):
    """Of the shape LUME_bezier_patch. Equal points are one point, so edges that meet are shared."""
    points, patch_indices = {}, []
    for patch in patches:
        corners = [tuple(c + 0.0 for c in p) for row in patch for p in row]  # no -0
        patch_indices.append([points.setdefault(p, len(points)) for p in corners])
    return {"points": [list(p) for p in points], "patches": patch_indices}
