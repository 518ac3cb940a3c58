// SPDX-License-Identifier: Apache-2.0
#include "io/compare/channel_image.h"

#include "io/compare/pixel_hash.h"
#include "io/error.h"
#include "tests/support/gltf_file.h"
#include "tests/support/paths.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <numeric>

namespace lume::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ChannelImages : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path path(const std::string& name) const {
    return folder_.path() / name;
  }

  /// Values 0, 1, 2 ... in steps, channel by channel of pixel by pixel.
  void write(const std::string& name, const std::vector<OIIO::ImageSpec>& parts, float step) const {
    const auto output = OIIO::ImageOutput::create(path(name).string());
    ASSERT_TRUE(output);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const OIIO::ImageSpec& spec = parts[i];
      std::vector<float> values(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
      std::iota(values.begin(), values.end(), 0.0f);
      for (float& value : values) value *= step;
      if (i == 0 && parts.size() > 1) {
        ASSERT_TRUE(
            output->open(path(name).string(), static_cast<int>(parts.size()), parts.data()));
      } else if (i == 0) {
        ASSERT_TRUE(output->open(path(name).string(), spec));
      } else {
        ASSERT_TRUE(output->open(path(name).string(), spec, OIIO::ImageOutput::AppendSubimage));
      }
      ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
    }
    ASSERT_TRUE(output->close());
  }

  [[nodiscard]] std::string problem(const std::string& name) const {
    try {
      static_cast<void>(read_channels(path(name)));
      return "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input_output);
      return error.what();
    }
  }

  tests::TemporaryFolder folder_;
};

TEST_F(ChannelImages, ExrWithLayersAndWindow_IsReadByName) {
  OIIO::ImageSpec spec(4, 3, 5, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"R", "G", "B", "depth.Z", "N.x"};
  spec.x = 2;
  spec.y = 1;
  spec.full_width = 8;
  spec.full_height = 6;
  write("layers.exr", {spec}, 1.0f);
  const ImageFile file = read_channels(path("layers.exr"));
  ASSERT_EQ(file.images.size(), 1u);
  const ChannelImage& image = file.images[0];
  EXPECT_EQ(image.full_width, 8);
  EXPECT_EQ(image.full_height, 6);
  EXPECT_EQ(image.region, (shading::PixelRegion{2, 1, 4, 3}));
  EXPECT_FALSE(image.display_referred);
  EXPECT_TRUE(has_color(image));
  const auto depth = std::find(image.channels.begin(), image.channels.end(), "depth.Z");
  ASSERT_NE(depth, image.channels.end());
  const auto& plane = image.planes[static_cast<std::size_t>(depth - image.channels.begin())];
  for (std::size_t i = 0; i < plane.size(); ++i) {
    EXPECT_EQ(plane[i], 5.0f * static_cast<float>(i) + 3.0f);
  }
  EXPECT_EQ(color_of(image).at(1, 0), shading::Color(5.0f, 6.0f, 7.0f));
}

TEST_F(ChannelImages, PartsOfAnExr_AreImagesWithNames) {
  OIIO::ImageSpec first(2, 2, 3, OIIO::TypeDesc::FLOAT);
  first.attribute("oiio:subimagename", "beauty");
  OIIO::ImageSpec second(2, 2, 1, OIIO::TypeDesc::FLOAT);
  second.channelnames = {"Z"};
  second.attribute("oiio:subimagename", "depth");
  write("parts.exr", {first, second}, 1.0f);
  const ImageFile file = read_channels(path("parts.exr"));
  ASSERT_EQ(file.images.size(), 2u);
  EXPECT_EQ(file.images[0].name, "beauty");
  EXPECT_EQ(file.images[1].name, "depth");
  EXPECT_THAT(file.images[1].planes[0], ElementsAre(0, 1, 2, 3));
}

TEST_F(ChannelImages, SixteenBitPng_IsNormalizedAndDisplayReferred) {
  write("deep.png", {OIIO::ImageSpec(4, 2, 3, OIIO::TypeDesc::UINT16)}, 1.0f / 65535.0f);
  const ImageFile file = read_channels(path("deep.png"));
  const ChannelImage& image = file.images.at(0);
  EXPECT_TRUE(image.display_referred);
  EXPECT_THAT(image.channels, ElementsAre("R", "G", "B"));
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_FLOAT_EQ(image.planes[1][i], static_cast<float>(3 * i + 1) / 65535.0f);
  }
}

TEST_F(ChannelImages, AlphaOfAPng_DoesNotDarkenItsColour) {
  OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  const auto output = OIIO::ImageOutput::create(path("thin.png").string());
  ASSERT_TRUE(output && output->open(path("thin.png").string(), spec));
  const unsigned char texel[] = {255, 128, 64, 51};
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, texel) && output->close());
  const ImageFile file = read_channels(path("thin.png"));
  EXPECT_FLOAT_EQ(file.images.at(0).planes[0][0], 1.0f);
  EXPECT_FLOAT_EQ(file.images.at(0).planes[1][0], 128.0f / 255.0f);
  EXPECT_FLOAT_EQ(file.images.at(0).planes[3][0], 0.2f);
}

TEST_F(ChannelImages, Grey_IsAllThreeColours) {
  write("grey.png", {OIIO::ImageSpec(2, 1, 1, OIIO::TypeDesc::UINT8)}, 0.2f);
  const RgbImage color = color_of(read_channels(path("grey.png")).images.at(0));
  EXPECT_EQ(color.at(0, 0), shading::Color(0.0f));
  EXPECT_NEAR(color.at(1, 0).x, 0.0331f, 1e-4f);
  EXPECT_EQ(color.at(1, 0).x, color.at(1, 0).z);
}

TEST_F(ChannelImages, PixelHash_IsOfThePixelsAndNotOfTheFile) {
  OIIO::ImageSpec zip(16, 9, 3, OIIO::TypeDesc::FLOAT);
  zip.attribute("compression", "zip");
  OIIO::ImageSpec none = zip;
  none.attribute("compression", "none");
  write("zip.exr", {zip}, 1.0f);
  write("none.exr", {none}, 1.0f);
  write("other.exr", {zip}, 1.0000001f);
  const std::string hash = pixel_hash(read_channels(path("zip.exr")));
  EXPECT_EQ(hash.size(), 32u);
  EXPECT_EQ(hash, pixel_hash(read_channels(path("none.exr"))));
  EXPECT_NE(hash, pixel_hash(read_channels(path("other.exr"))));
}

TEST_F(ChannelImages, FilesThatAreNone_AreOneLine) {
  EXPECT_THAT(problem("absent.exr"), HasSubstr("absent.exr: cannot be read"));
  std::ofstream(path("text.png")) << "no picture";
  EXPECT_THAT(problem("text.png"), HasSubstr("not an image"));
  write("whole.exr", {OIIO::ImageSpec(64, 64, 3, OIIO::TypeDesc::FLOAT)}, 1.0f);
  std::filesystem::resize_file(path("whole.exr"), file_size(path("whole.exr")) / 2);
  EXPECT_THAT(problem("whole.exr"), HasSubstr("whole.exr: "));
  EXPECT_THAT(problem("whole.exr"), testing::Not(HasSubstr("\n")));
}

}  // namespace
}  // namespace lume::io
