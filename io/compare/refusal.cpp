// SPDX-License-Identifier: Apache-2.0
#include "io/compare/refusal.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace lume::io {
namespace {

/// " of image 2" where there are several.
std::string of_image(const ImageFile& file, std::size_t index) {
  if (file.images.size() == 1) return "";
  const std::string& name = file.images[index].name;
  return name.empty() ? fmt::format(" of image {}", index + 1) : fmt::format(" of '{}'", name);
}

/// A sentence on the values that are not finite; empty if all are.
std::string non_finite_values(const ImageFile& file) {
  for (std::size_t i = 0; i < file.images.size(); ++i) {
    const ChannelImage& image = file.images[i];
    for (std::size_t c = 0; c < image.planes.size(); ++c) {
      const std::vector<float>& plane = image.planes[c];
      const auto is_bad = [](float value) { return !std::isfinite(value); };
      const auto first = std::find_if(plane.begin(), plane.end(), is_bad);
      if (first == plane.end()) continue;
      const auto at = static_cast<int>(first - plane.begin());
      const auto count = std::count_if(first, plane.end(), is_bad);
      return fmt::format("{}: {} of channel {}{} {} not finite; the first is {} at ({}, {})",
                         file.path, count == 1 ? "one value" : fmt::format("{} values", count),
                         image.channels[c], of_image(file, i), count == 1 ? "is" : "are", *first,
                         image.region.x + at % image.region.width,
                         image.region.y + at / image.region.width);
    }
  }
  return "";
}

std::string window_text(const shading::PixelRegion& region) {
  return fmt::format("{}x{}{:+}{:+}", region.width, region.height, region.x, region.y);
}

std::vector<std::string> sorted(std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  return names;
}

RefusalReason find_refusal(const ImageFile& actual, const ImageFile& expected, std::size_t i) {
  const ChannelImage& a = actual.images[i];
  const ChannelImage& e = expected.images[i];
  const std::string where = actual.path + of_image(actual, i);
  if (a.full_width != e.full_width || a.full_height != e.full_height) {
    return {Refusal::size, fmt::format("{}: the image is {}x{}, {}x{} is expected", where,
                                       a.full_width, a.full_height, e.full_width, e.full_height)};
  }
  if (a.region != e.region) {
    return {Refusal::data_window, fmt::format("{}: its data window is {}, {} is expected", where,
                                              window_text(a.region), window_text(e.region))};
  }
  if (sorted(a.channels) != sorted(e.channels)) {
    return {Refusal::channels,
            fmt::format("{}: its channels are {}; expected are {}", where,
                        fmt::join(sorted(a.channels), " "), fmt::join(sorted(e.channels), " "))};
  }
  return {};
}

}  // namespace

RefusalReason find_refusal(const ImageFile& actual, const ImageFile& expected) {
  for (const ImageFile* file : {&actual, &expected}) {
    std::string bad = non_finite_values(*file);
    if (!bad.empty()) return {Refusal::non_finite, std::move(bad)};
  }
  const std::size_t count = std::min(actual.images.size(), expected.images.size());
  for (std::size_t i = 0; i < count; ++i) {
    RefusalReason reason = find_refusal(actual, expected, i);
    if (reason.refusal != Refusal::none) return reason;
  }
  if (actual.images.size() != expected.images.size()) {
    return {Refusal::channels,
            fmt::format("{}: there are {} images in the file, {} are expected", actual.path,
                        actual.images.size(), expected.images.size())};
  }
  return {};
}

}  // namespace lume::io
