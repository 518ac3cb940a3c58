// SPDX-License-Identifier: Apache-2.0
// Bezier patches to test with.
#pragma once

#include "geometry/shapes/bezier_patch.h"
#include "tests/support/random.h"

#include <cmath>
#include <vector>

namespace lume::test {

using geometry::BezierPatch;
using geometry::DVec3;

/// The unit square in the plane z = 0, with u along x and v along y.
inline BezierPatch flat_patch() {
  BezierPatch patch;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const DVec3 place(column, row, 0.0);
      patch[4 * row + column] = place / 3.0;
    }
  }
  return patch;
}

/// A sheet of size 1 with bumps up to `bump`; with large ones it folds over itself.
inline BezierPatch random_patch(Random& random, float bump) {
  BezierPatch patch = flat_patch();
  for (DVec3& p : patch) p += DVec3(random.cube(bump)) - DVec3(0.5, 0.5, 0.0);
  return patch;
}

/// A closed surface around the origin: a cube with `n` x `n` patches on each face, its control
/// points on a bumpy sphere. Neighbours take theirs from the same lattice, so they share them.
inline std::vector<BezierPatch> closed_surface(int n) {
  const int last = 3 * n;
  std::vector<BezierPatch> patches;
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < n; ++row) {
      for (int column = 0; column < n; ++column) {
        BezierPatch patch;
        for (int k = 0; k < 16; ++k) {
          DVec3 p(0.0);
          p[face % 3] = face < 3 ? 0 : last;
          p[(face + 1) % 3] = 3 * column + k % 4;
          const int line = k / 4;
          p[(face + 2) % 3] = 3 * row + line;
          const double bump = 0.1 * std::sin(p.x + 2.0 * p.y + 3.0 * p.z);
          const DVec3 out = 2.0 / last * p - 1.0;
          patch[static_cast<std::size_t>(k)] = (1.0 + bump) * normalize(out);
        }
        patches.push_back(patch);
      }
    }
  }
  return patches;
}

/// The parabolic sheet z = 4 h u (1 - u) over the unit square.
inline BezierPatch arch(double h) {
  BezierPatch patch = flat_patch();
  for (std::size_t k = 0; k < 16; ++k) {
    if (k % 4 == 1 || k % 4 == 2) patch[k].z = 4.0 * h / 3.0;
  }
  return patch;
}

}  // namespace lume::test
