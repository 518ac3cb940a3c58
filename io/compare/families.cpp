// SPDX-License-Identifier: Apache-2.0
#include "io/compare/families.h"

#include "io/compare/estimates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace lume::io {
namespace {

constexpr double k_families = 3.0;

StatisticalFamily make_family(std::size_t tests, double significance) {
  StatisticalFamily family;
  family.tests = tests;
  family.threshold = significance / static_cast<double>(tests);
  family.log_threshold = std::log(family.threshold);
  return family;
}

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

double family_significance(const StatisticalSettings& settings) {
  return settings.significance / k_families;
}

StatisticalResult make_result(const PictureShape& shape, std::size_t tiles,
                              const StatisticalSettings& settings) {
  const double significance = family_significance(settings);
  StatisticalResult result;
  result.significance = settings.significance;
  result.pixels = make_family(shape.pixels() * shape.channels.size(), significance);
  result.tiles = make_family(tiles * shape.channels.size(), significance);
  result.image = make_family(shape.channels.size(), significance);
  return result;
}

void check_shapes(const PictureShape& actual, const PictureShape& expected,
                  const StatisticalSettings& settings) {
  if (actual.width < 1 || actual.height < 1 || actual.channels.empty()) {
    throw std::invalid_argument(
        fmt::format("a picture of {} x {} pixels with {} channels, expected at least one of each",
                    actual.width, actual.height, actual.channels.size()));
  }
  if (actual.width != expected.width || actual.height != expected.height) {
    throw std::invalid_argument(fmt::format("{} x {} pixels, expected {} x {} as on the other side",
                                            actual.width, actual.height, expected.width,
                                            expected.height));
  }
  if (actual.channels != expected.channels) {
    throw std::invalid_argument(fmt::format("channels {}, expected {} as on the other side",
                                            list(actual.channels), list(expected.channels)));
  }
  if (!(settings.significance > 0.0 && settings.significance < 1.0)) {
    throw std::invalid_argument(
        fmt::format("a significance of {}, expected more than 0, below 1", settings.significance));
  }
  if (settings.tile_size < 1 || !(settings.rounding >= 0.0)) {
    throw std::invalid_argument(
        fmt::format("tiles of {} pixels and a rounding of {}, expected at least 1 and 0",
                    settings.tile_size, settings.rounding));
  }
}

void check_planes(const std::vector<std::vector<float>>& planes, const PictureShape& shape) {
  if (planes.size() != shape.channels.size()) {
    throw std::invalid_argument(
        fmt::format("{} planes, expected {}", planes.size(), shape.channels.size()));
  }
  for (const std::vector<float>& plane : planes) {
    if (plane.size() != shape.pixels()) {
      throw std::invalid_argument(
          fmt::format("a plane of {} values, expected {}", plane.size(), shape.pixels()));
    }
    if (!std::all_of(plane.begin(), plane.end(), [](float v) { return std::isfinite(v); })) {
      throw std::invalid_argument("a value is infinite or no number, expected finite ones");
    }
  }
}

}  // namespace lume::io
