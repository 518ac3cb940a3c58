// SPDX-License-Identifier: Apache-2.0
// The first half of a build: references are cut in two, and in two again.
#pragma once

#include "geometry/accelerators/wide/split.h"
#include "geometry/accelerators/wide/wide_tree.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace lume::geometry::wide {

struct BinaryNode {
  static constexpr std::uint32_t k_none = 0xffff'ffffu;

  Range range;
  std::uint32_t left = k_none;  ///< none: a leaf
  std::uint32_t right = k_none;

  [[nodiscard]] bool is_leaf() const { return left == k_none; }
};

/// What is cut, and how far.
struct BinarySource {
  const TriangleItems* triangles = nullptr;  ///< to be cut through; may be null
  std::size_t leaf_size = 1;                 ///< ranges up to this size stay together
  double root_area = 0.0;                    ///< half that of the whole tree's box
};

/// Node 0 is the root; children come after their parents.
[[nodiscard]] std::vector<BinaryNode> build_binary(const Range& range, const BinarySource& source);

}  // namespace lume::geometry::wide
