// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/argument_parsing.h"

#include "renderer/cli/exit_codes.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>

namespace lume::cli {
namespace {

TEST(ParseWhole, NumbersInRange_AreTaken) {
  EXPECT_EQ(parse_whole("1", 1, 4), 1u);
  EXPECT_EQ(parse_whole("+4", 1, 4), 4u);
  const auto most = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(parse_whole("18446744073709551615", 0, most), most);
}

TEST(ParseWhole, EverythingElse_IsRefused) {
  for (const char* text : {"", "0", "5", "-1", "2.0", "1e0", "0x2", " 2", "2 ", "two", "++2", "+-2",
                           "99999999999999999999999"}) {
    EXPECT_THROW((void)parse_whole(text, 1, 4), UsageError) << text;
  }
}

TEST(ParseReal, NumbersInRange_AreTaken) {
  EXPECT_EQ(parse_real("-1.5", -2, 2), -1.5);
  EXPECT_EQ(parse_real("+1e0", -2, 2), 1.0);
  EXPECT_EQ(parse_real(".5", -2, 2), 0.5);
}

TEST(ParseReal, NotANumberOrOutside_IsRefused) {
  for (const char* text :
       {"", "nan", "-nan", "inf", "-inf", "1e999", "2.1", "1,5", "1.0f", "0x1p0"}) {
    EXPECT_THROW((void)parse_real(text, -2, 2), UsageError) << text;
  }
}

TEST(ParseTriple, ThreeNumbers_AreTaken) {
  EXPECT_EQ(parse_triple("1,-2.5,3e3", 1e6), geometry::DVec3(1.0, -2.5, 3000.0));
}

TEST(ParseTriple, EverythingElse_IsRefused) {
  for (const char* text :
       {"", "1,2", "1,2,3,4", "1,,3", "1, 2,3", "1,2,3,", "nan,0,0", "1,2,1e7"}) {
    EXPECT_THROW((void)parse_triple(text, 1e6), UsageError) << text;
  }
}

TEST(ParseCrop, RandomRectangles_ComeBack) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const shading::PixelRegion region{
        static_cast<int>(random() % 65536), static_cast<int>(random() % 65536),
        1 + static_cast<int>(random() % 65535), 1 + static_cast<int>(random() % 65535)};
    const std::string text = std::to_string(region.width) + "x" + std::to_string(region.height) +
                             "+" + std::to_string(region.x) + "+" + std::to_string(region.y);
    EXPECT_EQ(parse_crop(text), region) << text;
  }
}

TEST(ParseCrop, EverythingElse_IsRefused) {
  for (const char* text :
       {"", "x++", "1x1", "1x1+0", "0x1+0+0", "1x0+0+0", "1x1+-1+0", "1x1+0+0+0", "1x1+0+0 ",
        "-1x1+0+0", "1+1x0+0", "1x1++1+0", "70000x1+0+0", "1x1+0+99999999999"}) {
    EXPECT_THROW((void)parse_crop(text), UsageError) << text;
  }
}

TEST(ParseNames, ListsAndAll_AreTaken) {
  const std::vector<std::string> known = {"depth", "normal", "albedo"};
  EXPECT_EQ(parse_names("normal,depth,normal", "AOV", known),
            (std::vector<std::string>{"normal", "depth"}));
  EXPECT_EQ(parse_names("all", "AOV", known), known);
}

TEST(ParseNames, UnknownName_SuggestsTheNearest) {
  try {
    (void)parse_names("depth,norml", "AOV", {"depth", "normal"});
    FAIL() << "nothing thrown";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'normal'"), std::string::npos);
  }
  EXPECT_THROW((void)parse_names("", "AOV", {"depth"}), UsageError);
}

}  // namespace
}  // namespace lume::cli
