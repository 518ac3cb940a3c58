// SPDX-License-Identifier: Apache-2.0
#include "io/error.h"
#include "io/image_io.h"
#include "tests/io/file_bytes.h"
#include "tests/io/pictures.h"

#include <OpenImageIO/imageio.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/resource.h>

#include <cmath>
#include <csignal>

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
using tests::write_bytes;

WriteOptions standard_view() {
  WriteOptions options;
  options.view = ViewTransform(ViewRequest{{}, "sRGB", "Standard"});
  return options;
}

int expected_byte(float linear) {
  const double x = std::min(std::max(double{linear}, 0.0), 1.0);
  const double e = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
  return static_cast<int>(std::lround(255.0 * e));
}

/// The bytes of a display file. decode_image() has no need of TIFF, so that comes from the file.
std::vector<std::uint8_t> read_texels(const std::filesystem::path& path) {
  if (path.extension().string().starts_with(".tif")) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path.string(), &config);
    if (!input) return {};
    std::vector<std::uint8_t> texels(4 * input->spec().image_pixels());
    EXPECT_EQ(input->spec().get_int_attribute("oiio:UnassociatedAlpha"), 1);
    EXPECT_TRUE(input->read_image(0, 0, 0, 4, OIIO::TypeUInt8, texels.data()));
    return texels;
  }
  const shading::Image image = decode_image(read_bytes(path), path.string());
  return std::get<std::vector<std::uint8_t>>(image.texels);
}

class AlphaFormats : public ::testing::TestWithParam<const char*> {};

TEST_P(AlphaFormats, Colors_AreStoredUnassociatedAndRounded) {
  const Picture picture = make_picture(17, 9);
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / (std::string("picture") + GetParam());
  write_picture(path, picture, standard_view());
  const std::vector<std::uint8_t> texels = read_texels(path);
  ASSERT_EQ(texels.size(), 17u * 9 * 4);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const Vec4 pixel = picture.pixels[i];
    EXPECT_EQ(texels[4 * i + 3], std::lround(255.0f * pixel.w));
    if (texels[4 * i + 3] == 0) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const int expected = expected_byte(pixel[static_cast<int>(c)] / pixel.w);
      // One step where the value lies at a rounding boundary.
      ASSERT_NEAR(texels[4 * i + c], expected, 1) << GetParam() << " pixel " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, AlphaFormats,
                         ::testing::Values(".png", ".tif", ".tiff", ".webp", ".tga"),
                         [](const auto& test) { return std::string(test.param + 1); });

class OpaqueFormats : public ::testing::TestWithParam<const char*> {};

TEST_P(OpaqueFormats, Colors_AreOverBlack) {
  Picture picture = make_picture(16, 16);
  for (Vec4& pixel : picture.pixels) pixel = Vec4(0.1f, 0.2f, 0.05f, 0.25f);
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / (std::string("picture") + GetParam());
  write_picture(path, picture, standard_view());
  const std::vector<std::uint8_t> texels = read_texels(path);
  EXPECT_NEAR(texels[0], expected_byte(0.1f), 2);
  EXPECT_NEAR(texels[1], expected_byte(0.2f), 2);
  EXPECT_NEAR(texels[2], expected_byte(0.05f), 2);
  EXPECT_EQ(texels[3], 255);
}

INSTANTIATE_TEST_SUITE_P(All, OpaqueFormats, ::testing::Values(".jpg", ".jpeg", ".bmp"),
                         [](const auto& test) { return std::string(test.param + 1); });

TEST(WritePicture, Exposure_DoublesLightForEachStopInDisplayFormatsOnly) {
  Picture picture = make_picture(1, 1);
  picture.pixels = {Vec4(0.1f, 0.05f, 0.0f, 1.0f)};
  WriteOptions options = standard_view();
  options.exposure = 2.0f;
  const TemporaryFolder folder;
  write_picture(folder / "a.png", picture, options);
  const shading::Image image = decode_image(read_bytes(folder / "a.png"), "a");
  const auto& texels = std::get<std::vector<std::uint8_t>>(image.texels);
  EXPECT_EQ(texels[0], expected_byte(0.4f));
  EXPECT_EQ(texels[1], expected_byte(0.2f));
  write_picture(folder / "a.exr", picture, options);
  EXPECT_NEAR(read_channel(folder / "a.exr", "R").front(), 0.1f, 1e-4f);
}

TEST(WritePicture, DisplayFileOfARegion_HasOnlyItsPixelsAndNamesItsView) {
  Picture picture = make_picture(5, 4);
  picture.full_width = 100;
  picture.full_height = 50;
  picture.region = {20, 10, 5, 4};
  const TemporaryFolder folder;
  write_picture(folder / "crop.png", picture, {});
  const auto input = OIIO::ImageInput::open((folder / "crop.png").string());
  ASSERT_TRUE(input);
  EXPECT_EQ(input->spec().width, 5);
  EXPECT_EQ(input->spec().height, 4);
  EXPECT_EQ(input->spec().get_string_attribute("ImageDescription"),
            "PBR Neutral on sRGB, exposure +0 EV");
}

TEST(WritePicture, ExtensionsInCapitals_AreUnderstood) {
  const TemporaryFolder folder;
  EXPECT_EQ(message_of(folder / "A.PNG", make_picture(2, 2)), "no error");
  EXPECT_EQ(message_of(folder / "A.Exr", make_picture(2, 2)), "no error");
  EXPECT_EQ(count_files(folder), 2);
}

TEST(WritePicture, ExistingFile_IsReplacedAndALinkIsFollowed) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.png", "old");
  std::filesystem::create_symlink(folder / "a.png", folder / "link.png");
  write_picture(folder / "link.png", make_picture(3, 3), {});
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.png"));
  EXPECT_EQ(decode_image(read_bytes(folder / "a.png"), "a").width, 3);
  EXPECT_EQ(count_files(folder), 2);
}

TEST(WritePicture, PixelsThatDoNotFillTheRegion_AreAMistakeOfTheProgram) {
  Picture picture = make_picture(3, 3);
  picture.pixels.pop_back();
  EXPECT_THROW(write_picture("unused.png", picture, {}), std::invalid_argument);
}

/// Lets no file of this process grow beyond a few bytes, as a full disk would.
class SmallDisk {
 public:
  SmallDisk() : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_limit_);
    const rlimit small{16, old_limit_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &old_limit_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_limit_{};
  void (*old_handler_)(int);
};

TEST(WritePicture, DiskThatIsFull_IsAnErrorAndLeavesTheOldFileAlone) {
  const TemporaryFolder folder;
  const Picture picture = make_picture(20, 20);
  std::vector<std::string_view> extensions(scene_linear_extensions().begin(),
                                           scene_linear_extensions().end());
  extensions.insert(extensions.end(), display_extensions().begin(), display_extensions().end());
  std::ptrdiff_t files = 0;
  for (const std::string_view extension : extensions) {
    const std::filesystem::path path = folder / ("a" + std::string(extension));
    write_bytes(path, "old");
    {
      const SmallDisk small;
      EXPECT_THAT(message_of(path, picture), HasSubstr("cannot write")) << extension;
    }
    EXPECT_EQ(read_bytes(path).size(), 3u) << extension;
    EXPECT_EQ(count_files(folder), ++files) << "nothing half-written stays behind";
    EXPECT_EQ(message_of(path, picture), "no error") << extension;
  }
}

std::string refusal(const std::filesystem::path& path) {
  try {
    check_writable(path);
    return "no error";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(CheckWritable, UnknownExtension_SuggestsAndListsThose) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal(folder / "a.pgn"), HasSubstr("did you mean .png?"));
  EXPECT_THAT(refusal(folder / "a.pgn"), HasSubstr(".exr, .hdr, .pfm, .png, .jpg"));
  EXPECT_THAT(refusal(folder / "a"), HasSubstr("needs an extension"));
  EXPECT_THAT(refusal(folder / "a.gif"), HasSubstr(".gif"));
}

TEST(CheckWritable, FolderThatCannotBeUsed_IsNamed) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusal(folder / "a.png"), "no error");
  EXPECT_THAT(refusal(folder / "missing/a.png"), HasSubstr("there is no folder"));
  write_bytes(folder / "file", "x");
  EXPECT_THAT(refusal(folder / "file/a.png"), HasSubstr("there is no folder"));
  std::filesystem::create_directory(folder / "folder.png");
  EXPECT_THAT(refusal(folder / "folder.png"), HasSubstr("not a regular file"));
  EXPECT_THAT(message_of(folder / "missing/a.exr", make_picture(1, 1)),
              HasSubstr("there is no folder"));
}

TEST(CheckWritable, BareNames_MeanTheCurrentFolder) {
  EXPECT_EQ(refusal("picture.png"), "no error");
}

}  // namespace
}  // namespace lume::io
