// SPDX-License-Identifier: Apache-2.0
// Where space is divided, one item is in many cells, and a ray through several of them would test
// it again in each. A mailbox remembers what was tested. The first ones were a field in each item
// (Amanatides and Woo 1987, "A Fast Voxel Traversal Algorithm for Ray Tracing"), which threads
// would have to share; this one is a few numbers on the query's stack, each for the items that are
// hashed to it (as the inverse mailbox of Shevtsov, Soupikov and Kapustin 2007). What comes later
// takes the place of what was there: an item may be tested twice, but is never left out.
#pragma once

#include <array>
#include <cstdint>

namespace lume::geometry {

class Mailbox {
 public:
  /// False if the item is known to have been here.
  [[nodiscard]] bool is_new(std::uint32_t item) {
    std::uint32_t& last = last_[item % k_places];
    if (last == item + 1) return false;
    last = item + 1;
    return true;
  }

 private:
  static constexpr std::uint32_t k_places = 16;
  std::array<std::uint32_t, k_places> last_{};  ///< item + 1; 0: none yet
};

}  // namespace lume::geometry
