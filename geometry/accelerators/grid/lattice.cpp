// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/grid/lattice.h"

#include "geometry/accelerators/slab.h"

#include <cmath>
#include <limits>

namespace lume::geometry::grid {
namespace {

/// The edge of cubes of which `cells` fill a box. Along an axis on which the box is thinner than
/// that there is one cell, and the others share out the rest.
double cube_edge(const DVec3& size, double cells) {
  bool cut[3] = {true, true, true};
  double edge = 0.0;
  for (int round = 0; round < 3; ++round) {
    double volume = 1.0;
    int axes = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (round > 0) cut[axis] = cut[axis] && size[axis] > edge;
      if (!cut[axis]) continue;
      volume *= size[axis];
      ++axes;
    }
    if (axes == 0) break;
    edge = std::pow(volume / cells, 1.0 / axes);
  }
  return edge;
}

}  // namespace

Lattice::Lattice(const Items& items, double density) : all_(items.all_bounds()) {
  if (all_.is_empty()) return;
  const DVec3 size = DVec3(all_.upper) - DVec3(all_.lower);
  const double edge = cube_edge(size, density * items.size());
  const DVec3 farthest(glm::max(glm::abs(all_.lower), glm::abs(all_.upper)));
  for (int axis = 0; axis < 3; ++axis) {
    // There are no more places for items than there are floats.
    constexpr double k_float = 4.0 * static_cast<double>(std::numeric_limits<float>::epsilon());
    const double most = std::max(edge, k_float * farthest[axis]);
    if (!(size[axis] >= 2.0 * most)) continue;
    count_[axis] = static_cast<int>(size[axis] / most);
    size_[axis] = size[axis] / (count_[axis] - 2.0 * k_margin);
    per_length_[axis] = 1.0 / size_[axis];
    lower_[axis] = all_.lower[axis] - k_margin * size_[axis];
  }
}

Bounds Lattice::bounds(const Cell& cell) const {
  Bounds result = all_;
  for (int axis = 0; axis < 3; ++axis) {
    if (count_[axis] == 1) continue;
    constexpr float k_infinity = std::numeric_limits<float>::infinity();
    const double margin = k_margin * size_[axis];
    const double lower = plane(axis, cell[axis]) - margin;
    const double upper = plane(axis, cell[axis] + 1) + margin;
    result.lower[axis] = std::nextafter(static_cast<float>(lower), -k_infinity);
    result.upper[axis] = std::nextafter(static_cast<float>(upper), k_infinity);
  }
  return result;
}

bool Lattice::is_fine_for(const ObjectRay& ray) const {
  for (int axis = 0; axis < 3; ++axis) {
    // One slack for where the item is met, two for where a plane is crossed, and one to spare.
    const double rounded = 4.0 * slab_slack(ray, all_, axis);
    if (count_[axis] > 1 && rounded > k_margin * size_[axis]) return false;
  }
  return true;
}

}  // namespace lume::geometry::grid
