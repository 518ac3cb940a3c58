// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/wide/binary_tree.h"

namespace lume::geometry::wide {
namespace {

/// The cheaper of the two kinds of split.
Split find_split(const Range& range, const BinarySource& source) {
  // From here on halves, so that leaves are reached before the tree is too deep.
  if (range.depth >= k_max_depth / 2) return {};
  const Split whole = find_object_split(range);
  if (range.room == 0 || range.cuttable == 0) return whole;
  // Cuts pay where boxes overlap, seen from the whole tree (Stich et al. 2009, section 4.1) and
  // from the range itself: to look for them takes longer than all the rest.
  constexpr double k_of_tree = 1e-5;
  constexpr double k_of_range = 0.1;
  const bool worth_a_try = whole.axis < 0 || (whole.overlap > k_of_tree * source.root_area &&
                                              whole.overlap > k_of_range * range.box.half_area());
  if (!worth_a_try) return whole;
  const Split through = find_spatial_split(range, *source.triangles);
  return through.axis >= 0 && through.cost < whole.cost ? through : whole;
}

}  // namespace

std::vector<BinaryNode> build_binary(const Range& range, const BinarySource& source) {
  std::vector<BinaryNode> nodes;
  nodes.reserve(2 * (range.count / source.leaf_size) + 1);
  nodes.push_back({range});
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].range.count <= source.leaf_size) continue;
    auto [left, right] =
        apply_split(nodes[i].range, find_split(nodes[i].range, source), source.triangles);
    left.depth = right.depth = nodes[i].range.depth + 1;
    nodes[i].left = static_cast<std::uint32_t>(nodes.size());
    nodes[i].right = nodes[i].left + 1;
    nodes.push_back({left});
    nodes.push_back({right});
  }
  return nodes;
}

}  // namespace lume::geometry::wide
