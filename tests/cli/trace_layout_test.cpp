// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/trace_layout.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

namespace lume::cli {
namespace {

constexpr double k_column_gap = 10.0;
constexpr double k_row_gap = 20.0;

std::vector<TreeBox> random_tree(test::Random& random) {
  std::vector<TreeBox> boxes(1 + random.below(80));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::uint32_t recent =
        random.below(static_cast<std::uint32_t>(std::max<std::size_t>(i, 1)));
    boxes[i] = {random.uniform(5.0f, 90.0f), random.uniform(5.0f, 150.0f),
                random.uniform(20.0f, 100.0f), recent};
  }
  return boxes;
}

TEST(TraceLayout, RandomTrees_DoNotOverlap) {
  test::Random random(4);
  for (int tree = 0; tree < 300; ++tree) {
    const std::vector<TreeBox> boxes = random_tree(random);
    const TreeLayout layout = lay_out(boxes, k_column_gap, k_row_gap);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const TreePlace& a = layout.places[i];
      ASSERT_GE(a.x - boxes[i].left, -1e-6);
      ASSERT_LE(a.x + boxes[i].right, layout.width + 1e-6);
      ASSERT_LE(a.y + boxes[i].height, layout.height + 1e-6);
      for (std::size_t k = 0; k < i; ++k) {
        const TreePlace& b = layout.places[k];
        const bool apart_in_x = a.x - boxes[i].left >= b.x + boxes[k].right + k_column_gap - 1e-6 ||
                                b.x - boxes[k].left >= a.x + boxes[i].right + k_column_gap - 1e-6;
        const bool apart_in_y = a.y >= layout.level_bottoms[k] + k_row_gap - 1e-6 ||
                                b.y >= layout.level_bottoms[i] + k_row_gap - 1e-6;
        ASSERT_TRUE(apart_in_x || apart_in_y) << "nodes " << k << " and " << i;
      }
    }
  }
}

TEST(TraceLayout, Parent_StandsInTheMiddle) {
  const std::vector<TreeBox> boxes = {
      {5, 5, 10, 0}, {20, 20, 10, 0}, {5, 40, 10, 0}, {5, 5, 10, 0}};
  const TreeLayout layout = lay_out(boxes, k_column_gap, k_row_gap);
  EXPECT_DOUBLE_EQ(layout.places[0].x, 0.5 * (layout.places[1].x + layout.places[3].x));
  EXPECT_LT(layout.places[1].x, layout.places[2].x);
  EXPECT_LT(layout.places[2].x, layout.places[3].x);
  EXPECT_DOUBLE_EQ(layout.places[1].y, 10.0 + k_row_gap);
}

// A chain this long would overflow the stack of a recursive layout.
TEST(TraceLayout, LongChain_IsPlaced) {
  std::vector<TreeBox> boxes(3000, TreeBox{5, 5, 10, 0});
  for (std::size_t i = 1; i < boxes.size(); ++i) boxes[i].parent = i - 1;
  const TreeLayout layout = lay_out(boxes, k_column_gap, k_row_gap);
  EXPECT_DOUBLE_EQ(layout.places.back().y, 2999.0 * (10.0 + k_row_gap));
  EXPECT_DOUBLE_EQ(layout.width, 10.0);
}

}  // namespace
}  // namespace lume::cli
