// SPDX-License-Identifier: Apache-2.0
#include "io/compare/regions.h"

#include "geometry/parallel.h"
#include "io/compare/finding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lume::io {
namespace {

/// Two chances to fail instead of one: Bonferroni's correction.
constexpr double k_log_two_tests = std::numbers::ln2;

/// Offers what a region shows with and without fireflies. Returns the pair that is a new worst one.
const EstimatePair* offer(const TestedRegion& tested, const RegionRule& rule, SmallestP& smallest) {
  const double log_factor = tested.kept ? k_log_two_tests : 0.0;
  const EstimatePair* worst = nullptr;
  const auto try_pair = [&](const EstimatePair& pair) {
    const WelchTest test = welch_test(pair, rule.variance_ratio, rule.rounding);
    if (smallest.offer(test.t, test.degrees, log_factor)) worst = &pair;
  };
  try_pair(tested.all);
  if (tested.kept) try_pair(*tested.kept);
  return worst;
}

/// The relative bias that one region would have shown; infinite where all is black.
double detectable(const TestedRegion& tested, const RegionRule& rule, double log_threshold) {
  if (tested.kept) log_threshold -= k_log_two_tests;
  const auto of_pair = [&](const EstimatePair& pair) {
    const WelchTest test = welch_test(pair, rule.variance_ratio, rule.rounding);
    const double value = std::abs(pair.base + pair.expected.mean);
    if (value == 0.0) return std::numeric_limits<double>::infinity();
    const double noise = test.detectable(student_critical(log_threshold, test.degrees));
    return (noise + rule.rounding * pair.scale) / value;
  };
  const double all = of_pair(tested.all);
  return tested.kept ? std::min(all, of_pair(*tested.kept)) : all;
}

}  // namespace

std::vector<Region> tile_grid(int width, int height, int tile_size) {
  std::vector<Region> tiles;
  for (int y = 0; y < height; y += tile_size) {
    for (int x = 0; x < width; x += tile_size) {
      tiles.push_back({x, y, std::min(tile_size, width - x), std::min(tile_size, height - y)});
    }
  }
  return tiles;
}

double firefly_limit(std::vector<double> scores) {
  const auto middle = scores.begin() + static_cast<std::ptrdiff_t>(scores.size() / 2);
  std::nth_element(scores.begin(), middle, scores.end());
  return *middle > 0.0 ? *middle * k_firefly_factor : std::numeric_limits<double>::infinity();
}

bool any_region_reaches(const std::vector<TestedRegion>& regions, const RegionRule& rule,
                        SmallestP limit) {
  return std::any_of(regions.begin(), regions.end(), [&](const TestedRegion& tested) {
    return offer(tested, rule, limit) != nullptr;
  });
}

void test_regions(const std::vector<TestedRegion>& regions, const RegionRule& rule,
                  const PictureShape& shape, StatisticalFamily& family) {
  SmallestP smallest;
  Finding worst;
  for (const TestedRegion& tested : regions) {
    const EstimatePair* pair = offer(tested, rule, smallest);
    if (pair == nullptr) continue;
    worst = {tested.region, tested.channel, *pair, smallest.log_p()};
    family.without_fireflies = tested.kept && pair == &*tested.kept;
  }
  record(worst, shape, family);
}

void set_detectable_bias(const std::vector<TestedRegion>& regions, const RegionRule& rule,
                         double share, StatisticalFamily& family) {
  std::vector<double> biases(regions.size());
  geometry::parallel_for(regions.size(), [&](std::size_t i) {
    biases[i] = detectable(regions[i], rule, family.log_threshold);
  });
  biases.erase(std::remove_if(biases.begin(), biases.end(), [](double b) { return std::isinf(b); }),
               biases.end());
  if (biases.empty()) return;
  const auto last = static_cast<double>(biases.size() - 1);
  const auto place = biases.begin() + static_cast<std::ptrdiff_t>(share * last);
  std::nth_element(biases.begin(), place, biases.end());
  family.detectable_bias = *place;
}

}  // namespace lume::io
