// SPDX-License-Identifier: Apache-2.0
#include "io/compare/statistical_test.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace lume::io {
namespace {

std::string percent(double share) {
  return std::isfinite(share) ? fmt::format("{:.2g}%", 100.0 * share) : std::string("infinitely");
}

/// What a pass is worth.
std::string sensitivity(const StatisticalResult& result) {
  const auto& image = result.image.detectable_bias;
  const auto& tile = result.tiles.detectable_bias;
  if (!image || !tile) return "all is black, where no bias is relative";
  return fmt::format("would have seen a bias of {} of the whole image or {} of the median tile",
                     percent(*image), percent(*tile));
}

/// "p = 3.1e-12", of any size.
std::string probability(double log_p) {
  if (std::isinf(log_p)) return "p = 0";
  const double decades = log_p / std::numbers::ln10;
  const double exponent = std::floor(decades);
  if (exponent > -4.0) return fmt::format("p = {:.2g}", std::exp(log_p));
  return fmt::format("p = {:.1f}e{:.0f}", std::pow(10.0, decades - exponent), exponent);
}

std::string place(const StatisticalFamily& family, const std::string& name) {
  if (family.width == 1 && family.height == 1) {
    return fmt::format("{} ({}, {})", name, family.x, family.y);
  }
  return fmt::format("{} of {} x {} from ({}, {})", name, family.width, family.height, family.x,
                     family.y);
}

std::string failure(const StatisticalFamily& family, const std::string& where) {
  return fmt::format(
      "{} in {}{}: {:+.4g} or {} of what was expected, {} with {:.1e} allowed", where,
      family.channel, family.without_fireflies ? " without its fireflies" : "", family.difference,
      percent(family.relative_difference), probability(family.smallest_log_p), family.threshold);
}

}  // namespace

std::string describe(const StatisticalResult& result) {
  if (result.passed) return sensitivity(result);
  std::string text;
  const auto add = [&](const StatisticalFamily& family, const std::string& where) {
    if (!family.passed) text += (text.empty() ? "" : "; ") + failure(family, where);
  };
  add(result.image, "the whole image");
  add(result.tiles, place(result.tiles, "the tile"));
  add(result.pixels, place(result.pixels, "pixel"));
  return text;
}

}  // namespace lume::io
