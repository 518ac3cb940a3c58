// SPDX-License-Identifier: Apache-2.0
#include "shading/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace lume::shading {
namespace {

double stored_value(const Image& image, std::size_t i) {
  if (const auto* bytes = std::get_if<std::vector<std::uint8_t>>(&image.texels)) {
    return (*bytes)[i] / 255.0;
  }
  if (const auto* words = std::get_if<std::vector<std::uint16_t>>(&image.texels)) {
    return (*words)[i] / 65535.0;
  }
  return std::get<std::vector<float>>(image.texels)[i];
}

double decode_srgb(double e) {
  return e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4);
}

long wrap_slowly(long i, long size, Wrap wrap) {
  if (wrap == Wrap::clamp_to_edge) return std::min(std::max(i, 0L), size - 1);
  while (i < 0) i += 2 * size;
  i %= 2 * size;
  if (wrap == Wrap::repeat) return i % size;
  return i < size ? i : 2 * size - 1 - i;
}

/// Texel (x, y) of the endless wrapped image.
Vec4 texel_slowly(const Texture& texture, const Image& image, Encoding encoding, long x, long y) {
  const long column = wrap_slowly(x, image.width, texture.wrap_u);
  const long row = wrap_slowly(y, image.height, texture.wrap_v);
  Vec4 result;
  for (int c = 0; c < 4; ++c) {
    const double value =
        stored_value(image, static_cast<std::size_t>(4 * (row * image.width + column) + c));
    result[c] =
        static_cast<float>(encoding == Encoding::srgb && c < 3 ? decode_srgb(value) : value);
  }
  return result;
}

Vec4 sample_slowly(const Texture& texture, const Image& image, Encoding encoding, Vec2 uv) {
  const double x = static_cast<double>(uv.x) * image.width;
  const double y = static_cast<double>(uv.y) * image.height;
  if (texture.filter == Filter::nearest) {
    return texel_slowly(texture, image, encoding, static_cast<long>(std::floor(x)),
                        static_cast<long>(std::floor(y)));
  }
  Vec4 sum(0.0f);
  const long left = static_cast<long>(std::floor(x)) - 1;
  const long top = static_cast<long>(std::floor(y)) - 1;
  // Each texel weighs by the tent around its centre.
  for (long j = top; j <= top + 2; ++j) {
    for (long i = left; i <= left + 2; ++i) {
      const double weight = std::max(0.0, 1.0 - std::abs(x - (static_cast<double>(i) + 0.5))) *
                            std::max(0.0, 1.0 - std::abs(y - (static_cast<double>(j) + 0.5)));
      sum += static_cast<float>(weight) * texel_slowly(texture, image, encoding, i, j);
    }
  }
  return sum;
}

Image random_image(int width, int height, int type, std::mt19937& random) {
  Image image{"random", width, height, {}};
  const auto count = static_cast<std::size_t>(4 * width * height);
  const auto fill = [&](auto values) {
    for (std::size_t i = 0; i < count; ++i) {
      using T = std::decay_t<decltype(values[0])>;
      if constexpr (std::is_integral_v<T>) {
        values.push_back(static_cast<T>(random()));
      } else {
        values.push_back(std::uniform_real_distribution<float>(0.0f, 3.0f)(random));
      }
    }
    image.texels = std::move(values);
  };
  if (type == 0) fill(std::vector<std::uint8_t>{});
  if (type == 1) fill(std::vector<std::uint16_t>{});
  if (type == 2) fill(std::vector<float>{});
  return image;
}

bool near_edge(float coordinate, int size) {
  const double x = static_cast<double>(coordinate) * size;
  return std::abs(x - std::round(x)) < 1e-4;
}

TEST(Texture, RandomLookups_EqualTheSlowImplementation) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> coordinate(-4.0f, 5.0f);
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int k = 0; k < 300; ++k) {
    const Image image = random_image(1 + pick(9), 1 + pick(9), k % 3, random);
    const Texture texture{0, Wrap{pick(3)}, Wrap{pick(3)}, Filter{pick(2)}};
    const Encoding encoding{pick(2)};
    for (int i = 0; i < 40; ++i) {
      const Vec2 uv{coordinate(random), coordinate(random)};
      if (texture.filter == Filter::nearest &&
          (near_edge(uv.x, image.width) || near_edge(uv.y, image.height))) {
        continue;
      }
      const Vec4 expected = sample_slowly(texture, image, encoding, uv);
      const Vec4 actual = sample_texture(texture, image, encoding, uv);
      for (int c = 0; c < 4; ++c) {
        ASSERT_NEAR(actual[c], expected[c], 2e-4f) << uv.x << " " << uv.y << " case " << k;
      }
    }
  }
}

TEST(Texture, AllSrgbBytes_DecodeToTheStandardsCurve) {
  Image image{"ramp", 256, 1, {}};
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < 256; ++i) bytes.insert(bytes.end(), 4, static_cast<std::uint8_t>(i));
  image.texels = bytes;
  const Texture texture{0, Wrap::repeat, Wrap::repeat, Filter::nearest};
  for (int i = 0; i < 256; ++i) {
    const Vec2 uv{(static_cast<float>(i) + 0.5f) / 256.0f, 0.5f};
    const Vec4 value = sample_texture(texture, image, Encoding::srgb, uv);
    EXPECT_NEAR(value.x, decode_srgb(i / 255.0), 1e-6);
    EXPECT_NEAR(value.w, i / 255.0, 1e-6) << "alpha is linear";
  }
}

TEST(Texture, HalfwayBetweenBlackAndWhiteSrgb_IsHalfOfTheLight) {
  const Image image{"edge", 2, 1, std::vector<std::uint8_t>{0, 0, 0, 0, 255, 255, 255, 255}};
  const Texture texture{0, Wrap::clamp_to_edge, Wrap::clamp_to_edge, Filter::linear};
  const Vec4 value = sample_texture(texture, image, Encoding::srgb, {0.5f, 0.5f});
  EXPECT_NEAR(value.x, 0.5f, 1e-6f);
}

TEST(Texture, UvThatIsHugeOrNotANumber_ReturnsSomeTexel) {
  const Image image{"grey", 3, 2, std::vector<std::uint8_t>(24, 255)};
  constexpr float k_infinity = std::numeric_limits<float>::infinity();
  const float strange[] = {std::numeric_limits<float>::quiet_NaN(),
                           k_infinity,
                           -k_infinity,
                           std::numeric_limits<float>::max(),
                           std::numeric_limits<float>::lowest(),
                           1e20f,
                           -1e20f,
                           16777217.0f,
                           -1e-30f,
                           -0.0f,
                           1.0f,
                           2.0f};
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge}) {
    for (const Filter filter : {Filter::nearest, Filter::linear}) {
      for (const float u : strange) {
        for (const float v : strange) {
          const Vec4 value = sample_texture({0, wrap, wrap, filter}, image, Encoding::srgb, {u, v});
          EXPECT_EQ(value, Vec4(1.0f)) << u << " " << v;
        }
      }
    }
  }
}

TEST(TextureTransform, ExampleOfTheExtension_SelectsTheLowerLeftQuadrantTurned) {
  const TextureTransform transform{{0.0f, 1.0f}, 1.57079632679f, {0.5f, 0.5f}};
  const auto expect_uv = [&](Vec2 uv, Vec2 expected) {
    const Vec2 actual = transform.apply(uv);
    EXPECT_NEAR(actual.x, expected.x, 1e-6f);
    EXPECT_NEAR(actual.y, expected.y, 1e-6f);
  };
  expect_uv({0.0f, 0.0f}, {0.0f, 1.0f});
  expect_uv({1.0f, 0.0f}, {0.0f, 0.5f});
  expect_uv({0.0f, 1.0f}, {0.5f, 1.0f});
  expect_uv({1.0f, 1.0f}, {0.5f, 0.5f});
}

TEST(TextureTransform, SecondExample_FlipsV) {
  const TextureTransform transform{{0.0f, 1.0f}, 0.0f, {1.0f, -1.0f}};
  EXPECT_EQ(transform.apply({0.25f, 0.75f}), Vec2(0.25f, 0.25f));
}

TEST(TextureTransform, AnyValues_EqualTranslationTimesRotationTimesScale) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> value(-3.0f, 3.0f);
  for (int i = 0; i < 1000; ++i) {
    const TextureTransform t{
        {value(random), value(random)}, value(random), {value(random), value(random)}};
    const Vec2 uv{value(random), value(random)};
    // glm's matrices are listed by columns.
    const glm::mat3 translation(1, 0, 0, 0, 1, 0, t.offset.x, t.offset.y, 1);
    const float c = std::cos(t.rotation);
    const float s = std::sin(t.rotation);
    const glm::mat3 rotation(c, -s, 0, s, c, 0, 0, 0, 1);
    const glm::mat3 scale(t.scale.x, 0, 0, 0, t.scale.y, 0, 0, 0, 1);
    const Vec3 expected = translation * rotation * scale * Vec3(uv, 1.0f);
    EXPECT_NEAR(t.apply(uv).x, expected.x, 1e-4f);
    EXPECT_NEAR(t.apply(uv).y, expected.y, 1e-4f);
  }
}

TEST(Image, MemoryBytes_CountsTexels) {
  EXPECT_EQ((Image{"", 2, 2, std::vector<std::uint8_t>(16)}).memory_bytes(), 16u);
  EXPECT_EQ((Image{"", 2, 2, std::vector<std::uint16_t>(16)}).memory_bytes(), 32u);
  EXPECT_EQ((Image{"", 2, 2, std::vector<float>(16)}).memory_bytes(), 64u);
}

TEST(Checker, Squares_AlternateByTheParityOfTheirPlace) {
  Checker checker;
  checker.colors = {Vec4(0.9f, 0.1f, 0.05f, 1.0f), Vec4(0.95f, 0.85f, 0.1f, 0.5f)};
  checker.checks = {4.0f, 2.0f};
  std::mt19937 engine(5);
  std::uniform_real_distribution<float> coordinate(-50.0f, 50.0f);
  for (int i = 0; i < 10000; ++i) {
    const Vec2 uv(coordinate(engine), coordinate(engine));
    const auto column = static_cast<long>(std::floor(4.0 * static_cast<double>(uv.x)));
    const auto row = static_cast<long>(std::floor(2.0 * static_cast<double>(uv.y)));
    const std::size_t color = ((column + row) % 2 + 2) % 2 == 0 ? 0 : 1;
    ASSERT_EQ(checker.value(uv), checker.colors[color]) << uv.x << " " << uv.y;
  }
  EXPECT_EQ(checker.value({1e30f, 0.0f}), checker.colors[0]) << "far away all floats are even";
}

}  // namespace
}  // namespace lume::shading
