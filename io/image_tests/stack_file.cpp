// SPDX-License-Identifier: Apache-2.0
#include "io/image_tests/stack_file.h"

#include "io/error.h"
#include "io/one_line.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <system_error>

namespace lume::io {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw Error(ErrorKind::input_output, path.string(), "", reason);
}

OIIO::ImageSpec spec_of(const ChannelImage& image) {
  OIIO::ImageSpec spec(image.region.width, image.region.height,
                       static_cast<int>(image.channels.size()), OIIO::TypeDesc::FLOAT);
  spec.x = image.region.x;
  spec.y = image.region.y;
  spec.full_width = image.full_width;
  spec.full_height = image.full_height;
  spec.channelnames = image.channels;
  spec.attribute("oiio:subimagename", image.name);
  spec.attribute("compression", "zip");
  return spec;
}

std::vector<float> interleaved(const ChannelImage& image) {
  const std::size_t channels = image.planes.size();
  const std::size_t pixels = image.planes.front().size();
  std::vector<float> values(channels * pixels);
  for (std::size_t channel = 0; channel < channels; ++channel) {
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
      values[pixel * channels + channel] = image.planes[channel][pixel];
    }
  }
  return values;
}

/// What went wrong; empty if nothing.
std::string write_parts(const fs::path& path, const std::vector<ChannelImage>& images) {
  const auto output = OIIO::ImageOutput::create(path.string());
  if (!output) return one_line(OIIO::geterror());
  std::vector<OIIO::ImageSpec> specs;
  specs.reserve(images.size());
  for (const ChannelImage& image : images) specs.push_back(spec_of(image));
  bool good = output->open(path.string(), static_cast<int>(specs.size()), specs.data());
  for (std::size_t i = 0; good && i < images.size(); ++i) {
    if (i > 0) good = output->open(path.string(), specs[i], OIIO::ImageOutput::AppendSubimage);
    good = good && output->write_image(OIIO::TypeDesc::FLOAT, interleaved(images[i]).data());
  }
  good = output->close() && good;
  return good ? "" : one_line("cannot write: " + output->geterror());
}

bool is_alike(const ChannelImage& a, const ChannelImage& b) {
  return a.region.width == b.region.width && a.region.height == b.region.height &&
         a.channels == b.channels;
}

bool is_finite(const ChannelImage& image) {
  return std::all_of(image.planes.begin(), image.planes.end(), [](const auto& plane) {
    return std::all_of(plane.begin(), plane.end(),
                       [](float value) { return std::isfinite(value); });
  });
}

}  // namespace

void write_stack(const fs::path& path, const std::vector<ChannelImage>& images) {
  // OpenImageIO chooses the format by the extension, which therefore stays the last.
  const fs::path beside =
      path.parent_path() / fmt::format(".{}.{}.part.exr", path.stem().string(), getpid());
  const std::string problem = write_parts(beside, images);
  std::error_code error;
  if (problem.empty()) {
    fs::rename(beside, path, error);
    if (!error) return;
  }
  std::error_code ignored;
  fs::remove(beside, ignored);
  fail(path, problem.empty() ? "cannot write: " + error.message() : problem);
}

EstimateStack stack_of(const ImageFile& file) {
  if (file.images.size() < 2) {
    fail(file.path, fmt::format("has {} image; expected at least two, of different seeds",
                                file.images.size()));
  }
  const ChannelImage& first = file.images.front();
  EstimateStack stack{{first.region.width, first.region.height, first.channels}, {}, 0};
  stack.images.reserve(file.images.size());
  for (const ChannelImage& image : file.images) {
    if (!is_alike(image, first)) {
      fail(file.path,
           fmt::format("image '{}' differs from '{}' in size or channels", image.name, first.name));
    }
    if (!is_finite(image)) {
      fail(file.path, fmt::format("image '{}' has values that are not finite", image.name));
    }
    stack.images.push_back(image.planes);
  }
  return stack;
}

ChannelImage mean_of(const ImageFile& file) {
  ChannelImage mean = file.images.front();
  mean.name.clear();
  for (std::size_t channel = 0; channel < mean.planes.size(); ++channel) {
    std::vector<float>& plane = mean.planes[channel];
    for (std::size_t pixel = 0; pixel < plane.size(); ++pixel) {
      double sum = 0.0;
      for (const ChannelImage& image : file.images) {
        sum += static_cast<double>(image.planes[channel][pixel]);
      }
      plane[pixel] = static_cast<float>(sum / static_cast<double>(file.images.size()));
    }
  }
  return mean;
}

}  // namespace lume::io
