// SPDX-License-Identifier: Apache-2.0
#include "tests/io/file_bytes.h"
#include "tests/io/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace lume::io {
namespace {

using shading::Color;
using shading::Vec4;
using ::testing::HasSubstr;
using tests::count_files;
using tests::make_picture;
using tests::message_of;
using tests::read_bytes;
using tests::read_channel;
using tests::TemporaryFolder;

TEST(WritePicture, Exr_HasWindowsChannelsFormatsAndMetadata) {
  Picture picture = make_picture(7, 100);  // more rows than one band
  picture.full_width = 64;
  picture.full_height = 200;
  picture.region = {11, 22, 7, 100};
  picture.metadata = {{"lume:scene", "chair.glb"}, {"lume:samples", "64"}};
  picture.world_to_camera = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 4, 5, 1};
  Layer depth{{"Z"}, {}, true};
  Layer normal{{"N.x", "N.y", "N.z"}, {}, false};
  for (int i = 0; i < 700; ++i) {
    depth.pixels.push_back(1.0f + static_cast<float>(i) * 1e-6f);
    for (int c = 0; c < 3; ++c) normal.pixels.push_back(static_cast<float>(i % 8 - c) / 8.0f);
  }
  picture.layers = {depth, normal};
  const TemporaryFolder folder;
  write_picture(folder / "a.exr", picture, {});

  const auto input = OIIO::ImageInput::open((folder / "a.exr").string());
  ASSERT_TRUE(input);
  const OIIO::ImageSpec spec = input->spec();
  EXPECT_EQ(spec.x, 11);
  EXPECT_EQ(spec.y, 22);
  EXPECT_EQ(spec.width, 7);
  EXPECT_EQ(spec.height, 100);
  EXPECT_EQ(spec.full_x, 0);
  EXPECT_EQ(spec.full_y, 0);
  EXPECT_EQ(spec.full_width, 64);
  EXPECT_EQ(spec.full_height, 200);
  EXPECT_EQ(spec.nchannels, 8);
  EXPECT_EQ(spec.channelformat(spec.channelindex("R")), OIIO::TypeHalf);
  EXPECT_EQ(spec.channelformat(spec.channelindex("N.y")), OIIO::TypeHalf);
  EXPECT_EQ(spec.channelformat(spec.channelindex("Z")), OIIO::TypeFloat);
  EXPECT_EQ(spec.get_string_attribute("lume:scene"), "chair.glb");
  EXPECT_EQ(spec.get_string_attribute("lume:samples"), "64");
  EXPECT_EQ(spec.get_string_attribute("Software").substr(0, 5), "Lume ");
  EXPECT_EQ(spec.get_string_attribute("compression"), "zip");
  float matrix[16] = {};
  ASSERT_TRUE(spec.getattribute("worldToCamera", OIIO::TypeMatrix, matrix));
  EXPECT_TRUE(std::equal(std::begin(matrix), std::end(matrix), picture.world_to_camera.begin()));
  float chromaticities[8] = {};
  ASSERT_TRUE(spec.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8),
                                chromaticities));
  EXPECT_EQ(chromaticities[0], 0.64f);
  EXPECT_EQ(chromaticities[7], 0.3290f);

  EXPECT_EQ(read_channel(folder / "a.exr", "Z"), depth.pixels) << "exact in 32 bits";
  const std::vector<float> y = read_channel(folder / "a.exr", "N.y");
  const std::vector<float> alpha = read_channel(folder / "a.exr", "A");
  const std::vector<float> green = read_channel(folder / "a.exr", "G");
  for (std::size_t i = 0; i < 700; ++i) {
    ASSERT_EQ(y[i], normal.pixels[3 * i + 1]) << "eighths are exact in half";
    ASSERT_NEAR(alpha[i], picture.pixels[i].w, 0x1p-12f) << "half has 11 bits";
    ASSERT_NEAR(green[i], picture.pixels[i].y, 0x1p-12f);
  }
}

TEST(WritePicture, HalfOverflow_IsClampedAndNanBecomesZero) {
  Picture picture = make_picture(4, 1);
  constexpr float k_infinity = std::numeric_limits<float>::infinity();
  picture.pixels = {Vec4(1e6f, -1e6f, k_infinity, 1.0f), Vec4(NAN, 65504.0f, 65519.0f, 1.0f),
                    Vec4(1.0f + 0x1p-11f, 1.0f + 0x1.8p-10f, 0.1f, 1.0f), Vec4(0.0f)};
  picture.layers = {{{"id"}, {1e6f, 16777215.0f, 0.1f, -3e30f}, true}};
  const TemporaryFolder folder;
  write_picture(folder / "a.exr", picture, {});
  const auto red = read_channel(folder / "a.exr", "R");
  const auto green = read_channel(folder / "a.exr", "G");
  const auto blue = read_channel(folder / "a.exr", "B");
  EXPECT_EQ(red, (std::vector<float>{65504.0f, 0.0f, 1.0f, 0.0f})) << "a tie goes to even";
  EXPECT_EQ(green, (std::vector<float>{-65504.0f, 65504.0f, 1.0f + 0x1p-9f, 0.0f}));
  EXPECT_EQ(blue[0], 65504.0f);
  EXPECT_EQ(blue[1], 65504.0f);
  EXPECT_EQ(read_channel(folder / "a.exr", "id"), picture.layers[0].pixels);
}

TEST(WritePicture, FullFloatExr_IsExactInEveryCompressionWithoutLoss) {
  const Picture picture = make_picture(33, 70);
  const TemporaryFolder folder;
  for (const char* compression : {"none", "rle", "zip", "zips", "piz"}) {
    WriteOptions options;
    options.full_float = true;
    options.compression = compression;
    write_picture(folder / "a.exr", picture, options);
    const std::vector<float> blue = read_channel(folder / "a.exr", "B");
    ASSERT_EQ(blue.size(), picture.pixels.size());
    for (std::size_t i = 0; i < blue.size(); ++i) ASSERT_EQ(blue[i], picture.pixels[i].z);
  }
}

TEST(WritePicture, LossyExrCompressions_WriteBandsThatFitTogether) {
  Picture picture = make_picture(40, 300);
  for (Vec4& pixel : picture.pixels) pixel = Vec4(0.5f, 0.25f, 0.125f, 1.0f);
  const TemporaryFolder folder;
  for (const char* compression : {"pxr24", "b44", "b44a", "dwaa", "dwab"}) {
    WriteOptions options;
    options.compression = compression;
    write_picture(folder / "a.exr", picture, options);
    for (const float value : read_channel(folder / "a.exr", "G")) {
      ASSERT_NEAR(value, 0.25f, 0.005f) << compression;
    }
  }
}

TEST(WritePicture, UnknownCompression_SuggestsOne) {
  WriteOptions options;
  options.compression = "zps";
  const TemporaryFolder folder;
  EXPECT_THAT(message_of(folder / "a.exr", make_picture(2, 2), options),
              HasSubstr("did you mean zip"));
  EXPECT_EQ(count_files(folder), 0);
}

TEST(WritePicture, Hdr_KeepsRadianceToItsPrecision) {
  Picture picture = make_picture(20, 10);
  picture.pixels[3] = Vec4(1000.0f, 500.0f, 20.0f, 1.0f);
  const TemporaryFolder folder;
  write_picture(folder / "a.hdr", picture, {});
  const shading::Image image = decode_image(read_bytes(folder / "a.hdr"), "a");
  const auto& texels = std::get<std::vector<float>>(image.texels);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const float largest = shading::max_component(Color(picture.pixels[i]));
    for (int c = 0; c < 3; ++c) {
      ASSERT_NEAR(texels[4 * i + static_cast<std::size_t>(c)], picture.pixels[i][c],
                  largest / 128.0f + 1e-6f);
    }
  }
}

TEST(WritePicture, Pfm_IsBottomUpLittleEndian) {
  Picture picture = make_picture(2, 3);
  const TemporaryFolder folder;
  write_picture(folder / "a.pfm", picture, {});
  const std::vector<std::byte> bytes = read_bytes(folder / "a.pfm");
  const std::string header = "PF\n2 3\n-1.0\n";
  ASSERT_EQ(bytes.size(), header.size() + 6 * 3 * sizeof(float));
  EXPECT_EQ(std::memcmp(bytes.data(), header.data(), header.size()), 0);
  Color first;
  std::memcpy(&first, bytes.data() + header.size(), sizeof(first));
  EXPECT_EQ(first, Color(picture.pixels[4])) << "the left end of the lowest row";
}

}  // namespace
}  // namespace lume::io
