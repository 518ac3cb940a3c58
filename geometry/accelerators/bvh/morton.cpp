// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/bvh/morton.h"

#include "geometry/accelerators/bvh/top_down.h"

#include <algorithm>
#include <bit>

namespace lume::geometry::bvh {
namespace {

constexpr int k_bits = 21;  // of each axis; three of them fill 64 bits
static_assert(3 * k_bits + 32 <= k_max_depth);

/// Moves bit i to bit 3 i, by doubling the distance between halves, quarters, ... of what is left.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1f'ffffU;
  x = (x | x << 32U) & 0x001f'0000'0000'ffffU;
  x = (x | x << 16U) & 0x001f'0000'ff00'00ffU;
  x = (x | x << 8U) & 0x100f'00f0'0f00'f00fU;
  x = (x | x << 4U) & 0x10c3'0c30'c30c'30c3U;
  x = (x | x << 2U) & 0x1249'2492'4924'9249U;
  return x;
}

struct Place {
  std::uint64_t code = 0;
  std::uint32_t item = 0;

  bool operator<(const Place& other) const {
    return code != other.code ? code < other.code : item < other.item;
  }
};

std::vector<Place> sort_places(const Items& items) {
  const std::vector<Entry> entries = list_entries(items);
  const DBounds centroids = centroid_bounds(entries);
  const DVec3 size = centroids.size();
  std::vector<Place> places;
  places.reserve(entries.size());
  for (const Entry& entry : entries) {
    std::uint32_t cell[3] = {};
    for (int axis = 0; axis < 3; ++axis) {
      constexpr std::uint32_t k_cells = 1U << static_cast<unsigned>(k_bits);
      if (!(size[axis] > 0.0)) continue;
      const double place = (entry.twice_centroid(axis) - centroids.lower[axis]) / size[axis];
      cell[axis] = std::min(static_cast<std::uint32_t>(place * k_cells), k_cells - 1);
    }
    places.push_back({morton_code(cell[0], cell[1], cell[2]), entry.item});
  }
  std::sort(places.begin(), places.end());
  return places;
}

/// Where the highest bit in which the codes differ turns from 0 to 1: at a plane that halves the
/// cell around all of them.
std::size_t split(std::span<const Place> places, int /*depth*/) {
  constexpr std::size_t k_leaf = 4;
  if (places.size() <= k_leaf) return 0;
  const std::uint64_t differing = places.front().code ^ places.back().code;
  if (differing == 0) return places.size() / 2;  // in one cell: by number
  const std::uint64_t highest = std::bit_floor(differing);
  const auto second =
      std::partition_point(places.begin(), places.end(),
                           [highest](const Place& place) { return (place.code & highest) == 0; });
  return static_cast<std::size_t>(second - places.begin());
}

}  // namespace

std::uint64_t morton_code(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return spread(x) << 2U | spread(y) << 1U | spread(z);
}

BinaryTree build_lbvh(const Items& items) {
  std::vector<Place> places = sort_places(items);
  return build_top_down(items, places, split);
}

}  // namespace lume::geometry::bvh
