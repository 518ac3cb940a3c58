// SPDX-License-Identifier: Apache-2.0
#include "io/compare/channel_image.h"

#include "io/error.h"
#include "io/image_guards.h"
#include "io/one_line.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

namespace lume::io {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw Error(ErrorKind::input_output, path, "", one_line(reason));
}

std::unique_ptr<OIIO::ImageInput> open(const std::string& path) {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // values as they stand in the file
  auto input = OIIO::ImageInput::open(path, &config);
  if (input) return input;
  static_cast<void>(OIIO::geterror());  // it lists what each of its readers thought
  fail(path, "not an image in a format that can be read");
}

bool is_integer(const OIIO::ImageSpec& spec) {
  const auto base = static_cast<OIIO::TypeDesc::BASETYPE>(spec.format.basetype);
  return base != OIIO::TypeDesc::HALF && base != OIIO::TypeDesc::FLOAT &&
         base != OIIO::TypeDesc::DOUBLE;
}

std::vector<std::vector<float>> read_planes(OIIO::ImageInput& input, int index,
                                            const OIIO::ImageSpec& spec, const std::string& path) {
  const auto channels = static_cast<std::size_t>(spec.nchannels);
  const std::size_t pixels =
      static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
  std::vector<float> values(pixels * channels);
  if (!input.read_image(index, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data())) {
    fail(path, "cannot be read: " + input.geterror());
  }
  std::vector<std::vector<float>> planes(channels, std::vector<float>(pixels));
  for (std::size_t c = 0; c < channels; ++c) {
    for (std::size_t i = 0; i < pixels; ++i) planes[c][i] = values[i * channels + c];
  }
  return planes;
}

ChannelImage read_one(OIIO::ImageInput& input, int index, const OIIO::ImageSpec& spec,
                      std::uintmax_t file_bytes, const std::string& path) {
  if (spec.deep || spec.depth > 1 || spec.nchannels < 1) {
    fail(path, "expected a flat image with channels");
  }
  check_image_size(spec.width, spec.height, file_bytes, path);
  ChannelImage image;
  image.name = spec.get_string_attribute("oiio:subimagename", spec.get_string_attribute("name"));
  image.full_width = spec.full_width;
  image.full_height = spec.full_height;
  image.region = {spec.x - spec.full_x, spec.y - spec.full_y, spec.width, spec.height};
  image.display_referred = is_integer(spec);
  image.channels = spec.channelnames;
  image.planes = read_planes(input, index, spec, path);
  return image;
}

std::optional<std::size_t> find_channel(const ChannelImage& image, const std::string& name) {
  const auto found = std::find(image.channels.begin(), image.channels.end(), name);
  if (found == image.channels.end()) return std::nullopt;
  return static_cast<std::size_t>(found - image.channels.begin());
}

/// Which channels to show as red, green and blue.
std::array<std::optional<std::size_t>, 3> color_channels(const ChannelImage& image) {
  std::array<std::optional<std::size_t>, 3> rgb = {
      find_channel(image, "R"), find_channel(image, "G"), find_channel(image, "B")};
  if (rgb[0] || rgb[1] || rgb[2]) return rgb;
  std::optional<std::size_t> grey = find_channel(image, "Y");
  if (!grey && image.channels.size() == 1) grey = 0;
  return {grey, grey, grey};
}

}  // namespace

ImageFile read_channels(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (error) fail(name, "cannot be read: " + error.message());
  const auto input = open(name);
  ImageFile file{name, {}};
  for (int index = 0; input->seek_subimage(index, 0); ++index) {
    const OIIO::ImageSpec spec = input->spec();
    file.images.push_back(read_one(*input, index, spec, bytes, name));
  }
  static_cast<void>(input->geterror());  // that there is no further image
  if (file.images.empty()) fail(name, "there is no image in it");
  return file;
}

bool has_color(const ChannelImage& image) {
  const auto rgb = color_channels(image);
  return rgb[0] || rgb[1] || rgb[2];
}

RgbImage color_of(const ChannelImage& image) {
  const std::size_t pixels = image.planes.empty() ? 0 : image.planes[0].size();
  RgbImage result{image.region.width, image.region.height, {}};
  result.pixels.resize(pixels, shading::Color(0.0f));
  const auto rgb = color_channels(image);
  for (int c = 0; c < 3; ++c) {
    const auto channel = rgb[static_cast<std::size_t>(c)];
    if (!channel) continue;
    const std::vector<float>& plane = image.planes[*channel];
    for (std::size_t i = 0; i < pixels; ++i) {
      const float value = std::isfinite(plane[i]) ? plane[i] : 0.0f;
      result.pixels[i][c] = image.display_referred ? shading::srgb_to_linear(value) : value;
    }
  }
  return result;
}

}  // namespace lume::io
