// SPDX-License-Identifier: Apache-2.0
#include "geometry/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace lume::geometry {
namespace {

TEST(ParallelFor, EveryIndex_IsVisitedOnce) {
  for (const unsigned threads : {1u, 2u, 7u}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(limit.threads(), threads);
    std::vector<std::atomic<int>> visits(1000);
    parallel_for(visits.size(), [&](std::size_t i) { ++visits[i]; });
    for (const auto& count : visits) ASSERT_EQ(count.load(), 1);
  }
}

TEST(ParallelFor, OfSeveralExceptions_TheLowestIndexReachesTheCaller) {
  for (int round = 0; round < 200; ++round) {
    try {
      parallel_for(100, [](std::size_t i) {
        if (i % 20 == 13) throw std::runtime_error(std::to_string(i));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      ASSERT_STREQ(error.what(), "13");
    }
  }
}

TEST(ParallelFor, Cancelled_LeavesOutWhatHasNotBegun) {
  std::atomic<bool> cancel = false;
  std::atomic<int> visits = 0;
  parallel_for(
      100000,
      [&](std::size_t) {
        if (++visits == 100) cancel = true;
      },
      &cancel);
  EXPECT_LT(visits.load(), 1000);
  parallel_for(
      10, [&](std::size_t) { visits = -1; }, &cancel);
  EXPECT_NE(visits.load(), -1);
}

TEST(ThreadLimit, Zero_IsOnePerCore) { EXPECT_GE(ThreadLimit(0).threads(), 1u); }

}  // namespace
}  // namespace lume::geometry
