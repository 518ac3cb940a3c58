// SPDX-License-Identifier: Apache-2.0
#include "io/nearest_name.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace lume::io {
namespace {

TEST(EditDistance, KnownWords_HaveKnownDistances) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("redner", "render"), 1u);  // two neighbours swapped
}

std::string random_word(std::mt19937& random) {
  std::string word(random() % 8, ' ');
  for (char& c : word) c = static_cast<char>('a' + random() % 3);
  return word;
}

TEST(EditDistance, RandomWords_KeepTheLawsOfADistance) {
  std::mt19937 random(1);
  for (int i = 0; i < 5000; ++i) {
    const std::string a = random_word(random);
    const std::string b = random_word(random);
    const std::size_t distance = edit_distance(a, b);
    const std::size_t longer = std::max(a.size(), b.size());
    const std::size_t shorter = std::min(a.size(), b.size());
    EXPECT_EQ(distance, edit_distance(b, a)) << a << ' ' << b;
    EXPECT_EQ(distance == 0, a == b) << a << ' ' << b;
    EXPECT_LE(distance, longer) << a << ' ' << b;
    EXPECT_GE(distance, longer - shorter) << a << ' ' << b;
  }
}

TEST(EditDistance, OneRandomEdit_IsAtMostOne) {
  std::mt19937 random(2);
  for (int i = 0; i < 5000; ++i) {
    const std::string word = random_word(random) + "xyz";
    std::string edited = word;
    const std::size_t at = random() % (edited.size() - 1);
    switch (random() % 4) {
      case 0:
        edited.erase(at, 1);
        break;
      case 1:
        edited.insert(at, 1, 'q');
        break;
      case 2:
        edited[at] = 'q';
        break;
      default:
        std::swap(edited[at], edited[at + 1]);
    }
    EXPECT_EQ(edit_distance(word, edited), word == edited ? 0u : 1u) << word << ' ' << edited;
  }
}

TEST(NearestName, Typo_FindsTheName) {
  const std::vector<std::string> names = {"depth", "position", "normal", "geometric_normal"};
  EXPECT_EQ(nearest_name("dept", names), "depth");
  EXPECT_EQ(nearest_name("positoin", names), "position");
  EXPECT_EQ(nearest_name("NORMAL", names), "normal");
}

TEST(NearestName, NothingNear_FindsNothing) {
  EXPECT_EQ(nearest_name("velocity", {"depth", "normal"}), "");
  EXPECT_EQ(nearest_name("x", {}), "");
  EXPECT_EQ(nearest_name("abc", {std::string(1000000, 'a')}), "");
}

}  // namespace
}  // namespace lume::io
