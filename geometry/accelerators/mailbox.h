// SPDX-License-Identifier: Apache-2.0
// Where space is divided, one item is in many cells, and a ray through several of them would test
// it again in each. A mailbox remembers the last items that were tested. The first ones were a
// field in each item (Amanatides and Woo 1987, section 3), which threads would have to share; this
// one is a few numbers on the query's stack, where what is hashed to one place forgets what was
// there before: it may test twice, but never too little (as the inverse mailbox of Shevtsov,
// Soupikov and Kapustin 2007, "Highly Parallel Fast KD-tree Construction for Interactive Ray
// Tracing of Dynamic Scenes").
#pragma once

#include <array>
#include <cstdint>
#include <limits>

namespace lume::geometry {

class Mailbox {
 public:
  Mailbox() { last_.fill(std::numeric_limits<std::uint32_t>::max()); }

  /// False if the item is known to have been here.
  [[nodiscard]] bool is_new(std::uint32_t item) {
    std::uint32_t& last = last_[item % k_places];
    if (last == item) return false;
    last = item;
    return true;
  }

 private:
  static constexpr std::uint32_t k_places = 16;
  std::array<std::uint32_t, k_places> last_;  // NOLINT: filled in the constructor
};

}  // namespace lume::geometry
