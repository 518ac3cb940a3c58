// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/suggest.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lume::cli {
namespace {

TEST(UnknownName, ManyNames_ListIsCutOff) {
  std::vector<std::string> names;
  names.reserve(100);
  for (int i = 0; i < 100; ++i) names.push_back("camera " + std::to_string(i) + "\x1b[31m");
  const std::string message = unknown_name("camera", "front\n", names);
  EXPECT_EQ(message.find_first_of("\n\x1b"), std::string::npos) << message;
  EXPECT_NE(message.find("88 more"), std::string::npos) << message;
  EXPECT_LT(message.size(), 400u);
}

}  // namespace
}  // namespace lume::cli
