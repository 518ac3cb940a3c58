// SPDX-License-Identifier: Apache-2.0
#include "io/error.h"
#include "io/image_guards.h"
#include "io/image_io.h"
#include "io/one_line.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lume::io {
namespace {

using shading::Color;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw Error(ErrorKind::input_output, path.string(), "", one_line(reason));
}

std::unique_ptr<OIIO::ImageInput> open_environment(const std::filesystem::path& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error) fail(path, "cannot read the environment: " + error.message());
  auto input = OIIO::ImageInput::open(path.string());
  if (!input) fail(path, "cannot read the environment: " + OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.depth > 1 || spec.nchannels < 1) fail(path, "expected a flat image with channels");
  check_image_size(spec.width, spec.height, size, path.string());
  return input;
}

/// Which channels hold red, green and blue: those so named, else the first three, else grey.
std::array<int, 3> color_channels(const OIIO::ImageSpec& spec) {
  const std::array named{spec.channelindex("R"), spec.channelindex("G"), spec.channelindex("B")};
  if (std::all_of(named.begin(), named.end(), [](int channel) { return channel >= 0; })) {
    return named;
  }
  return spec.nchannels >= 3 ? std::array{0, 1, 2} : std::array{0, 0, 0};
}

float usable(float radiance) {
  return std::isfinite(radiance) && radiance > 0.0f ? radiance : 0.0f;
}

}  // namespace

shading::Environment read_environment(const std::filesystem::path& path) {
  const auto input = open_environment(path);
  const OIIO::ImageSpec spec = input->spec();
  const std::array<int, 3> channels = color_channels(spec);
  const auto [first, last] = std::minmax({channels[0], channels[1], channels[2]});
  const auto stride = static_cast<std::size_t>(last - first) + 1;
  std::vector<float> values(stride * spec.image_pixels());
  if (!input->read_image(0, 0, first, last + 1, OIIO::TypeFloat, values.data())) {
    fail(path, "cannot read the environment: " + input->geterror());
  }

  const bool encoded = !spec.format.is_floating_point();
  std::vector<Color> pixels(spec.image_pixels());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const auto channel = static_cast<std::size_t>(channels[static_cast<std::size_t>(c)] - first);
      const float value = usable(values[i * stride + channel]);
      pixels[i][c] = encoded ? shading::srgb_to_linear(value) : value;
    }
  }
  return {spec.width, spec.height, std::move(pixels)};
}

}  // namespace lume::io
