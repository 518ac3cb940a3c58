// SPDX-License-Identifier: Apache-2.0
#include "io/compare/label_exchange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace lume::io {
namespace {

TEST(LabelExchange, Count_IsTheBinomialCoefficient) {
  EXPECT_EQ(count_labellings(8, 8, 10000), 12870u / 2);  // to swap both changes nothing
  EXPECT_EQ(count_labellings(6, 6, 10000), 924u / 2);
  EXPECT_EQ(count_labellings(2, 23, 10000), 300u);
  EXPECT_EQ(count_labellings(23, 2, 10000), 300u);
  EXPECT_EQ(count_labellings(2, 2, 10000), 3u);
  EXPECT_EQ(count_labellings(64, 64, 3000), 3000u);
  EXPECT_EQ(count_labellings(8, 32, 3000), 3000u);
}

TEST(LabelExchange, DrawnLabels_AreAllDifferent) {
  for (const auto& [actual, expected, count] :
       {std::tuple{8, 8, 500}, std::tuple{5, 9, 500}, std::tuple{2, 2, 2}}) {
    std::set<Labels> seen;
    for (const Labels& labels :
         draw_labellings(static_cast<std::size_t>(actual), static_cast<std::size_t>(expected),
                         static_cast<std::size_t>(count))) {
      EXPECT_EQ(labels.size(), static_cast<std::size_t>(actual));
      EXPECT_TRUE(std::is_sorted(labels.begin(), labels.end()));
      EXPECT_LT(labels.back(), static_cast<std::uint32_t>(actual + expected));
      EXPECT_EQ(std::adjacent_find(labels.begin(), labels.end()), labels.end());
      if (actual == expected) {
        EXPECT_EQ(labels.front(), 0u);
      }
      EXPECT_NE(labels, true_labels(static_cast<std::size_t>(actual)));
      EXPECT_TRUE(seen.insert(labels).second);
    }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(count));
  }
}

TEST(LabelExchange, DrawnLabels_TakeEveryImageAsOften) {
  std::vector<int> counts(20);
  for (const Labels& labels : draw_labellings(5, 15, 4000)) {
    for (const std::uint32_t i : labels) ++counts[i];
  }
  for (const int count : counts) EXPECT_NEAR(count, 1000, 130);  // 5 standard deviations
}

}  // namespace
}  // namespace lume::io
