// SPDX-License-Identifier: Apache-2.0
#include "io/image_io.h"
#include "io/error.h"
#include "tests/io/file_bytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace lume::io {
namespace {

using shading::Color;
using shading::Image;
using shading::Vec4;
using ::testing::HasSubstr;
using ::testing::Not;
using tests::read_bytes;
using tests::TemporaryFolder;
using tests::write_bytes;

std::span<const std::byte> as_bytes(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
    return "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input_output);
    EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
    return error.what();
  }
}

std::string decoding_error(std::span<const std::byte> bytes) {
  return message_of([&] { static_cast<void>(decode_image(bytes, "picture 7")); });
}

const std::vector<std::uint8_t>& bytes_of(const Image& image) {
  return std::get<std::vector<std::uint8_t>>(image.texels);
}

/// A picture with smooth colours, encoded by our own writer.
std::vector<std::byte> encoded(const std::string& extension, int width, int height) {
  Picture picture;
  picture.full_width = width;
  picture.full_height = height;
  picture.region = {0, 0, width, height};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      picture.pixels.emplace_back(static_cast<float>(x) / static_cast<float>(width),
                                  static_cast<float>(y) / static_cast<float>(height), 0.5f, 1.0f);
    }
  }
  const TemporaryFolder folder;
  write_picture(folder / ("picture" + extension), picture, {});
  return read_bytes(folder / ("picture" + extension));
}

std::uint64_t checksum(const Image& image) {
  return std::visit(
      [](const auto& values) {
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
          sum += (i % 251 + 1) * static_cast<std::uint64_t>(values[i]);
        }
        return sum;
      },
      image.texels);
}

struct KnownPng {
  const char* name;
  int width;
  int height;
  int bits;
  std::uint64_t checksum;  ///< of the RGBA texels, by a PNG decoder written for this table
};

constexpr KnownPng k_png_suite[] = {
    {"basn0g01", 32, 32, 8, 79765785},      {"basn0g02", 32, 32, 8, 81465190},
    {"basn0g04", 32, 32, 8, 77496234},      {"basn0g08", 32, 32, 8, 81624144},
    {"basn0g16", 32, 32, 16, 22603791219},  {"basn2c08", 32, 32, 8, 105298698},
    {"basn2c16", 32, 32, 16, 17952114011},  {"basn3p01", 32, 32, 8, 90854222},
    {"basn3p02", 32, 32, 8, 72921585},      {"basn3p04", 32, 32, 8, 81807383},
    {"basn3p08", 32, 32, 8, 81440713},      {"basn4a08", 32, 32, 8, 63905315},
    {"basn4a16", 32, 32, 16, 14947948444},  {"basn6a08", 32, 32, 8, 65140472},
    {"basn6a16", 32, 32, 16, 13114060640},  {"ftbbn0g01", 32, 32, 8, 34767465},
    {"ftbbn0g02", 32, 32, 8, 26095425},     {"ftbbn0g04", 32, 32, 8, 83198629},
    {"ftbbn2c16", 32, 32, 16, 21249423353}, {"ftbbn3p08", 32, 32, 8, 82631083},
    {"ftbgn2c16", 32, 32, 16, 21249423353}, {"ftbgn3p08", 32, 32, 8, 82631083},
    {"ftbrn2c08", 32, 32, 8, 82682550},     {"ftbwn0g16", 32, 32, 16, 21481205338},
    {"ftbwn3p08", 32, 32, 8, 82631083},     {"ftbyn3p08", 32, 32, 8, 82631083},
    {"ftp0n0g08", 32, 32, 8, 76841553},     {"ftp0n2c08", 32, 32, 8, 75942371},
    {"ftp0n3p08", 32, 32, 8, 75922014},     {"ftp1n3p08", 32, 32, 8, 82631083},
};

class PngSuite : public ::testing::TestWithParam<KnownPng> {};

TEST_P(PngSuite, PlainAndInterlaced_DecodeToTheKnownTexels) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "LUME_TEST_DATA is not set";
  const std::filesystem::path folder = *data / "gltf/images/pngsuite";
  const KnownPng& known = GetParam();
  int found = 0;
  for (const char* prefix : {"", "i"}) {
    const std::filesystem::path path = folder / (prefix + std::string(known.name) + ".png");
    if (!std::filesystem::exists(path)) continue;  // not all of them come interlaced
    ++found;
    const Image image = decode_image(read_bytes(path), path.string());
    EXPECT_EQ(image.width, known.width);
    EXPECT_EQ(image.height, known.height);
    EXPECT_EQ(image.texels.index(), known.bits == 8 ? 0u : 1u);
    EXPECT_EQ(checksum(image), known.checksum) << path;
    const Image probe = probe_image(read_bytes(path), path.string());
    EXPECT_EQ(probe.width, known.width);
    EXPECT_EQ(probe.memory_bytes(), 0u);
  }
  EXPECT_GT(found, 0);
}

INSTANTIATE_TEST_SUITE_P(All, PngSuite, ::testing::ValuesIn(k_png_suite),
                         [](const auto& test) { return test.param.name; });

TEST(DecodeImage, GreyPnm_IsRepeatedAndOpaque) {
  const Image image = decode_image(as_bytes("P5\n2 1\n255\n" + std::string("\x10\xff")), "grey");
  EXPECT_EQ(bytes_of(image), (std::vector<std::uint8_t>{16, 16, 16, 255, 255, 255, 255, 255}));
}

TEST(DecodeImage, ColorPnm_IsOpaque) {
  const Image image = decode_image(as_bytes("P6\n1 1\n255\nabc"), "colour");
  EXPECT_EQ(bytes_of(image), (std::vector<std::uint8_t>{'a', 'b', 'c', 255}));
}

TEST(DecodeImage, HdrFile_BecomesFloat) {
  const Image image = decode_image(encoded(".hdr", 8, 4), "hdr");
  const auto& texels = std::get<std::vector<float>>(image.texels);
  ASSERT_EQ(texels.size(), 4u * 8 * 4);
  constexpr std::size_t k_fifth_texel = 16;
  EXPECT_NEAR(texels[k_fifth_texel], 0.5f, 0.01f);
  EXPECT_EQ(texels[3], 1.0f);
}

TEST(DecodeImage, TruncatedJpeg_IsAnErrorAndPaddingIsNot) {
  std::vector<std::byte> jpeg = encoded(".jpg", 64, 48);
  const Image whole = decode_image(jpeg, "jpeg");
  EXPECT_EQ(whole.width, 64);
  constexpr std::size_t k_row = 256;  // values
  constexpr std::size_t k_middle = 24 * k_row + 128;
  EXPECT_NEAR(bytes_of(whole)[k_middle], bytes_of(whole)[k_middle + k_row], 6);

  for (const std::size_t length : {jpeg.size() - 1, jpeg.size() - 2, jpeg.size() / 2}) {
    EXPECT_THAT(decoding_error(std::span(jpeg).first(length)), HasSubstr("picture 7: the JPEG"));
  }
  for (std::size_t length = 0; length < jpeg.size(); length += 7) {
    EXPECT_NE(decoding_error(std::span(jpeg).first(length)), "no error") << length;
  }
  jpeg.insert(jpeg.end(), 37, std::byte{0});
  jpeg.push_back(std::byte{0x42});
  EXPECT_EQ(bytes_of(decode_image(jpeg, "jpeg")), bytes_of(whole));
}

TEST(DecodeImage, TruncatedPngAndWebp_AreErrors) {
  for (const char* extension : {".png", ".webp"}) {
    const std::vector<std::byte> bytes = encoded(extension, 40, 30);
    EXPECT_EQ(decoding_error(bytes), "no error");
    for (const std::size_t length : {std::size_t{10}, std::size_t{30}, bytes.size() / 2}) {
      EXPECT_THAT(decoding_error(std::span(bytes).first(length)), HasSubstr("picture 7"))
          << extension << " " << length;
    }
  }
}

TEST(DecodeImage, FlippedBytes_NeverCrash) {
  for (const char* extension : {".png", ".jpg", ".webp"}) {
    const std::vector<std::byte> bytes = encoded(extension, 24, 16);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
      std::vector<std::byte> damaged = bytes;
      damaged[i] ^= std::byte{0xff};
      static_cast<void>(decoding_error(damaged));
    }
  }
}

TEST(DecodeImage, HeaderThatLiesAboutItsSize_IsRefusedWithoutAllocating) {
  EXPECT_THAT(decoding_error(as_bytes("P5\n60000 60000\n255\nabc")), HasSubstr("60000 x 60000"));
  EXPECT_THAT(decoding_error(as_bytes("P5\n16000 16000\n255\nabc")),
              HasSubstr("more than its bytes can hold"));
}

TEST(DecodeImage, BytesThatAreNoImage_AreAnError) {
  EXPECT_THAT(decoding_error({}), HasSubstr("picture 7"));
  EXPECT_THAT(decoding_error(as_bytes("hello, this is text and not a picture")),
              HasSubstr("not an image"));
  EXPECT_THAT(decoding_error(as_bytes(std::string("RIFF\x10\0\0\0WEBPVP8 ", 16))),
              HasSubstr("WebP"));
}

TEST(DecodeImage, ContentDecides_NotTheName) {
  EXPECT_EQ(decode_image(encoded(".jpg", 8, 8), "wrong.png").width, 8);
}

TEST(ReadEnvironment, ExrIsLinear_AndBadValuesBecomeZero) {
  Picture picture;
  picture.full_width = 2;
  picture.full_height = 1;
  picture.region = {0, 0, 2, 1};
  picture.pixels = {Vec4(1.0f, -2.0f, NAN, 1.0f), Vec4(1.0f, 8.0f, 0.5f, 1.0f)};
  const TemporaryFolder folder;
  WriteOptions options;
  options.full_float = true;
  write_picture(folder / "sky.exr", picture, options);
  const shading::Environment sky = read_environment(folder / "sky.exr");
  // The centres of the two texels are -z and +z.
  const Color first = sky.radiance({0.0f, 0.0f, -1.0f});
  const Color second = sky.radiance({0.0f, 0.0f, 1.0f});
  EXPECT_NEAR(first.x, 1.0f, 1e-4f);
  EXPECT_NEAR(first.y, 0.0f, 1e-4f);
  EXPECT_NEAR(first.z, 0.0f, 1e-4f);
  EXPECT_NEAR(second.y, 8.0f, 1e-4f);
  EXPECT_NEAR(second.z, 0.5f, 1e-4f);
}

TEST(ReadEnvironment, IntegerFormats_AreDecodedFromSrgb) {
  const TemporaryFolder folder;
  write_bytes(folder / "grey.pgm", "P5\n2 1\n255\n" + std::string("\x80\x80"));
  const shading::Environment grey = read_environment(folder / "grey.pgm");
  EXPECT_NEAR(grey.radiance({0.0f, 0.0f, 1.0f}).x, 0.2158605f, 1e-5f);
  EXPECT_NEAR(grey.radiance({0.0f, 0.0f, 1.0f}).z, 0.2158605f, 1e-5f);
}

TEST(ReadEnvironment, UnreadableFiles_AreErrorsWithTheirPath) {
  const TemporaryFolder folder;
  write_bytes(folder / "text.hdr", "no radiance here");
  write_bytes(folder / "empty.exr", "");
  for (const char* name : {"missing.exr", "text.hdr", "empty.exr", "."}) {
    const std::filesystem::path path = folder / name;
    EXPECT_THAT(message_of([&] { static_cast<void>(read_environment(path)); }),
                HasSubstr(path.string()));
  }
}

}  // namespace
}  // namespace lume::io
