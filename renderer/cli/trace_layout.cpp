// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/trace_layout.h"

#include <algorithm>
#include <limits>

namespace lume::cli {
namespace {

/// How far a subtree reaches to both sides of its root's axis, level by level.
struct Reach {
  double left;
  double right;
};
using Outline = std::vector<Reach>;

/// How far right of the first outline's axis the second one's can stand at the nearest.
double distance(const Outline& first, const Outline& second, double gap) {
  double result = 0.0;
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
    result = std::max(result, first[i].right + gap + second[i].left);
  }
  return result;
}

/// Adds an outline whose axis stands `offset` right of this one's.
void merge(Outline& outline, const Outline& other, double offset) {
  for (std::size_t i = 0; i < other.size(); ++i) {
    const Reach reach{other[i].left - offset, other[i].right + offset};
    if (i == outline.size()) {
      outline.push_back(reach);
    } else {
      outline[i].left = std::max(outline[i].left, reach.left);
      outline[i].right = std::max(outline[i].right, reach.right);
    }
  }
}

/// Puts the children side by side below the node; their offsets from its axis go to `offsets`.
Outline join(const TreeBox& box, const std::vector<std::size_t>& children,
             std::vector<Outline>& outlines, double gap, std::vector<double>& offsets) {
  Outline below;
  double last = 0.0;
  for (const std::size_t child : children) {
    last = below.empty() ? 0.0 : distance(below, outlines[child], gap);
    offsets[child] = last;
    merge(below, outlines[child], last);
    outlines[child] = {};
  }
  const double middle = 0.5 * last;
  Outline outline = {{box.left, box.right}};
  for (const Reach& reach : below) outline.push_back({reach.left + middle, reach.right - middle});
  for (const std::size_t child : children) offsets[child] -= middle;
  return outline;
}

/// Every row below the one before, as high as its highest node.
void stack_levels(const std::vector<TreeBox>& boxes, double row_gap, TreeLayout& layout) {
  std::vector<std::size_t> levels(boxes.size(), 0);
  std::vector<double> heights(1, 0.0);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (i > 0) levels[i] = levels[boxes[i].parent] + 1;
    if (levels[i] == heights.size()) heights.push_back(0.0);
    heights[levels[i]] = std::max(heights[levels[i]], boxes[i].height);
  }
  std::vector<double> tops(1, 0.0);
  for (const double height : heights) tops.push_back(tops.back() + height + row_gap);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    layout.places[i].y = tops[levels[i]];
    layout.level_bottoms.push_back(tops[levels[i]] + heights[levels[i]]);
  }
  layout.height = tops.back() - row_gap;
}

}  // namespace

TreeLayout lay_out(const std::vector<TreeBox>& boxes, double column_gap, double row_gap) {
  TreeLayout layout;
  if (boxes.empty()) return layout;
  layout.places.resize(boxes.size());
  std::vector<std::vector<std::size_t>> children(boxes.size());
  for (std::size_t i = 1; i < boxes.size(); ++i) children[boxes[i].parent].push_back(i);

  // From the leaves up; parents stand before their children.
  std::vector<Outline> outlines(boxes.size());
  std::vector<double> offsets(boxes.size(), 0.0);
  for (std::size_t i = boxes.size(); i-- > 0;) {
    outlines[i] = join(boxes[i], children[i], outlines, column_gap, offsets);
  }
  double left = 0.0;
  double right = 0.0;
  for (const Reach& reach : outlines[0]) {
    left = std::max(left, reach.left);
    right = std::max(right, reach.right);
  }
  layout.width = left + right;
  layout.places[0].x = left;
  for (std::size_t i = 1; i < boxes.size(); ++i) {
    layout.places[i].x = layout.places[boxes[i].parent].x + offsets[i];
  }
  stack_levels(boxes, row_gap, layout);
  return layout;
}

}  // namespace lume::cli
