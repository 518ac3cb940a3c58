// SPDX-License-Identifier: Apache-2.0
// Where the nodes of a drawn tree go.
#pragma once

#include <cstddef>
#include <vector>

namespace lume::cli {

/// What a node takes up (pixels), from the axis on which its parent's line arrives.
struct TreeBox {
  double left = 0.0;
  double right = 0.0;
  double height = 0.0;
  std::size_t parent = 0;  ///< stands before its children; the root's, number 0, is its own
};

struct TreePlace {
  double x = 0.0;  ///< of the axis
  double y = 0.0;  ///< of the top; the same for all nodes of a level
};

struct TreeLayout {
  std::vector<TreePlace> places;
  std::vector<double> level_bottoms;  ///< y below everything of the level, by node
  double width = 0.0;
  double height = 0.0;
};

/// Places each node in the middle above its children, and subtrees as close as their outlines allow
/// (after Reingold and Tilford 1981, "Tidier Drawings of Trees"). Children keep their order.
[[nodiscard]] TreeLayout lay_out(const std::vector<TreeBox>& boxes, double column_gap,
                                 double row_gap);

}  // namespace lume::cli
