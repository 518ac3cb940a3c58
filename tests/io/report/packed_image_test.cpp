// SPDX-License-Identifier: Apache-2.0
#include "io/report/packed_image.h"
#include "tests/io/report/packed_pages.h"
#include "tests/support/random.h"

#include <bit>

namespace lume::io {
namespace {

using shading::Color;
using test::half_value;
using test::unpack;

template <class Value>
RgbImage random_image(int width, int height, const Value& value) {
  RgbImage image{width, height, {}};
  image.pixels.reserve(static_cast<std::size_t>(width * height));
  for (int i = 0; i < width * height; ++i) {
    const float red = value();
    const float green = value();
    image.pixels.emplace_back(red, green, value());
  }
  return image;
}

TEST(PackedImage, EveryHalf_ComesBackBitForBit) {
  RgbImage image{256, 256, {}};
  for (std::uint32_t bits = 0; bits < 65536; ++bits) {
    const std::uint32_t other = (bits * 40503u) & 0xFFFFu;
    image.pixels.emplace_back(half_value(bits), half_value(other), half_value(65535u - bits));
  }
  const PackedImage packed = pack_scene_linear(image);
  ASSERT_EQ(packed.format, "half");
  EXPECT_FALSE(packed.rounded);
  const auto codes = unpack(packed.data, 256, 256, 3, 2);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const float value = half_value(codes[static_cast<std::size_t>(c)][i]);
      if (std::isnan(image.pixels[i][c])) {
        EXPECT_TRUE(std::isnan(value));
      } else {
        ASSERT_EQ(std::bit_cast<std::uint32_t>(value),
                  std::bit_cast<std::uint32_t>(image.pixels[i][c]));
      }
    }
  }
}

TEST(PackedImage, SmallImageOfOtherFloats_ComesBackBitForBit) {
  test::Random random(1);
  const auto value = [&] {
    return std::exp(random.uniform(-80.0f, 80.0f)) * random.uniform(-1, 1);
  };
  const RgbImage image = random_image(37, 23, value);
  const PackedImage packed = pack_scene_linear(image);
  ASSERT_EQ(packed.format, "float");
  EXPECT_FALSE(packed.rounded);
  const auto codes = unpack(packed.data, 37, 23, 3, 4);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      ASSERT_EQ(codes[static_cast<std::size_t>(c)][i],
                std::bit_cast<std::uint32_t>(image.pixels[i][c]));
    }
  }
}

TEST(PackedImage, LargeImageOfOtherFloats_IsRoundedAndStaysFinite) {
  test::Random random(2);
  const auto value = [&] { return std::exp(random.uniform(-8.0f, 16.0f)); };
  const RgbImage image = random_image(160, 120, value);
  const PackedImage packed = pack_scene_linear(image);
  ASSERT_EQ(packed.format, "half");
  EXPECT_TRUE(packed.rounded);
  const auto codes = unpack(packed.data, 160, 120, 3, 2);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const float expected = std::min(image.pixels[i][c], 65504.0f);
      const float value_back = half_value(codes[static_cast<std::size_t>(c)][i]);
      ASSERT_NEAR(value_back, expected, 0x1p-11f * expected);
    }
  }
}

TEST(PackedImage, DisplayCodes_AreOf8BitsWhereThoseDo) {
  for (const int most : {255, 65535}) {
    test::Random random(3);
    std::vector<std::uint32_t> written;
    const auto value = [&] {
      written.push_back(random.below(static_cast<std::uint32_t>(most) + 1u));
      return shading::srgb_to_linear(static_cast<float>(written.back()) / static_cast<float>(most));
    };
    const RgbImage image = random_image(50, 40, value);
    const PackedImage packed = pack_display_referred(image);
    ASSERT_EQ(packed.format, most == 255 ? "srgb8" : "srgb16");
    const auto codes = unpack(packed.data, 50, 40, 3, most == 255 ? 1 : 2);
    for (std::size_t i = 0; i < written.size(); ++i) ASSERT_EQ(codes[i % 3][i / 3], written[i]);
  }
}

TEST(PackedImage, Map_IsClampedTo255ths) {
  const std::vector<float> map = {0.0f, 1.0f, 0.5f, -3.0f, 7.0f, std::nanf("")};
  const PackedImage packed = pack_map(map, 3, 2);
  EXPECT_EQ(packed.format, "unit8");
  const auto codes = unpack(packed.data, 3, 2, 1, 1);
  EXPECT_EQ(codes[0], (std::vector<std::uint32_t>{0, 255, 128, 0, 255, 0}));
}

TEST(PackedImage, SmoothImage_TakesLessThanATenth) {
  RgbImage image{200, 100, {}};
  for (int i = 0; i < 20000; ++i) {
    const float x = static_cast<float>(i % 200) / 256.0f;
    image.pixels.emplace_back(x, x, x);
  }
  EXPECT_LT(pack_scene_linear(image).data.size(), 20000u * 6u / 10u);
}

}  // namespace
}  // namespace lume::io
