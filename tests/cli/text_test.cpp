// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/text.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <string>

namespace lume::cli {
namespace {

TEST(Text, Printable_TakesTheTeethOutOfControlCharacters) {
  EXPECT_EQ(printable("a\nb\tc"), "a b c");
  EXPECT_EQ(printable("red\x1b[31m\x7f"), "red?[31m?");
  EXPECT_EQ(printable("M\xc3\xbchle"), "M\xc3\xbchle");
}

TEST(Text, Count_HasThousandsSeparators) {
  EXPECT_EQ(format_count(0), "0");
  EXPECT_EQ(format_count(999), "999");
  EXPECT_EQ(format_count(1000), "1,000");
  EXPECT_EQ(format_count(123456789), "123,456,789");
}

TEST(Text, Bytes_TakeTheUnitThatFits) {
  EXPECT_EQ(format_bytes(1023), "1023 B");
  EXPECT_EQ(format_bytes(1536), "1.5 KiB");
  EXPECT_EQ(format_bytes(std::uint64_t{2} << 30), "2.0 GiB");
}

TEST(Text, Duration_ReadsWellAtEveryScale) {
  EXPECT_EQ(format_duration(0.25), "0.25 s");
  EXPECT_EQ(format_duration(9.94), "9.9 s");
  EXPECT_EQ(format_duration(9.96), "10 s");
  EXPECT_EQ(format_duration(59.6), "1 min 00 s");
  EXPECT_EQ(format_duration(185.0), "3 min 05 s");
  EXPECT_EQ(format_duration(7260.0), "2 h 01 min");
  EXPECT_EQ(format_duration(std::numeric_limits<double>::quiet_NaN()), "?");
  EXPECT_EQ(format_duration(std::numeric_limits<double>::infinity()), "?");
}

TEST(Text, Vector_HasNoMinusZero) { EXPECT_EQ(format_vector({-0.0, 1.5, -3.0}), "(0, 1.5, -3)"); }

TEST(Text, ShellQuote_QuotesOnlyWhatNeedsIt) {
  EXPECT_EQ(shell_quote("scenes/a-1.glb"), "scenes/a-1.glb");
  EXPECT_EQ(shell_quote("two words"), "'two words'");
  EXPECT_EQ(shell_quote("it's $HOME"), "'it'\\''s $HOME'");
  EXPECT_EQ(shell_quote(""), "''");
}

}  // namespace
}  // namespace lume::cli
