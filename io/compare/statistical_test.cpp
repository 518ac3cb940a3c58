// SPDX-License-Identifier: Apache-2.0
#include "io/compare/statistical_test.h"

#include "geometry/parallel.h"
#include "io/compare/families.h"
#include "io/compare/pixel_family.h"
#include "io/compare/pooled_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <stdexcept>

namespace lume::io {
namespace {

/// What the variances of the means should be to each other, by the numbers of samples.
double variance_ratio(const EstimateStack& actual, const EstimateStack& expected) {
  const bool known = actual.samples > 0 && expected.samples > 0;
  const auto samples = [&](const EstimateStack& stack) {
    return static_cast<double>(stack.images.size()) *
           (known ? static_cast<double>(stack.samples) : 1.0);
  };
  return samples(expected) / samples(actual);
}

/// Other labels are asked up to this many times as often as they have to be. At once, the chance of
/// who is asked would cost power.
constexpr std::size_t k_precision = 10;
/// How many labellings are tried in parallel before it is asked whether that is enough.
constexpr std::size_t k_pixel_batch = 32;
constexpr std::size_t k_region_batch = 1024;

/// True if, under these labels, a test's p is below what `limit` has seen.
using Reaches = std::function<bool(const Labels& labels, const SmallestP& limit)>;

/// The tests of two stacks, under the true labels and under others.
class StackTests {
 public:
  StackTests(const EstimateStack& actual, const EstimateStack& expected,
             const StatisticalSettings& settings)
      : shape_(actual.shape),
        actual_(actual.images.size()),
        expected_(expected.images.size()),
        settings_(settings),
        rule_{variance_ratio(actual, expected), settings.rounding},
        stack_(actual, expected, settings.tile_size, actual.samples == expected.samples) {
    // To be the worst of n at a significance of 1 / n is as rare as it has to be.
    const auto n = static_cast<std::size_t>(std::ceil(1.0 / exchange_significance()));
    const std::size_t labellings = count_labellings(actual_, expected_, k_precision * n);
    exchangeable_ = labellings >= n;
    few_ = n - 1;
    many_ = labellings - 1;
  }

  [[nodiscard]] StatisticalResult run() const {
    StatisticalResult result = make_result(shape_, stack_.tiles().size(), settings_);
    const Labels labels = true_labels(actual_);
    std::vector<TestedRegion> tiles = stack_.tile_estimates(labels);
    const std::vector<TestedRegion> image = stack_.image_estimates(labels);
    if (!exchangeable_) doubt_constants(tiles, pixel_tests(labels));
    test_pixels(pixel_tests(labels), shape_, result.pixels);
    test_regions(tiles, rule_, shape_, result.tiles);
    test_regions(image, rule_, shape_, result.image);
    set_detectable_bias(tiles, rule_, 0.5, result.tiles);
    set_detectable_bias(image, rule_, 1.0, result.image);
    doubt_all(result);
    result.fireflies = stack_.fireflies();
    result.passed = result.pixels.passed && result.tiles.passed && result.image.passed;
    return result;
  }

 private:
  [[nodiscard]] PixelTests pixel_tests(const Labels& labels) const {
    const auto read = [&](const Region& region, std::size_t channel,
                          std::vector<EstimatePair>& out) {
      stack_.pixel_estimates(labels, region, channel, out);
    };
    return {stack_.tiles(), shape_.channels.size(), read, rule_, !exchangeable_};
  }

  void doubt_all(StatisticalResult& result) const {
    // Pixels take long; theirs is the coarser answer.
    doubt(result.pixels, {few_, k_pixel_batch}, [&](const Labels& labels, const SmallestP& limit) {
      return any_pixel_reaches(pixel_tests(labels), limit);
    });
    doubt(result.tiles, {many_, k_region_batch}, [&](const Labels& labels, const SmallestP& limit) {
      return any_region_reaches(stack_.tile_estimates(labels), rule_, limit);
    });
    doubt(result.image, {many_, k_region_batch}, [&](const Labels& labels, const SmallestP& limit) {
      return any_region_reaches(stack_.image_estimates(labels), rule_, limit);
    });
  }

  /// To be surer than this takes too many labels; p itself must do.
  [[nodiscard]] double exchange_significance() const {
    return std::max(family_significance(settings_), 1e-4);
  }

  struct Effort {
    std::size_t labellings = 0;
    std::size_t batch = 1;
  };

  /// A failure stands if hardly any other labels look as bad.
  void doubt(StatisticalFamily& family, const Effort& effort, const Reaches& reaches) const {
    if (family.passed || !exchangeable_) return;
    // What is as small but for rounding is as small; what no double holds has no order.
    const SmallestP limit(std::max(family.smallest_log_p, -1e300) * (1.0 - 1e-9));
    const std::vector<Labels> labellings = draw_labellings(actual_, expected_, effort.labellings);
    const double significance = exchange_significance();
    std::size_t as_bad = 1;  // the true labels
    std::size_t asked = 1;
    while (asked <= effort.labellings) {
      const std::size_t count = std::min(effort.batch, effort.labellings + 1 - asked);
      std::vector<std::uint8_t> reached(count);
      geometry::parallel_for(count, [&](std::size_t i) {
        reached[i] = reaches(labellings[asked - 1 + i], limit) ? 1 : 0;
      });
      as_bad += static_cast<std::size_t>(std::count(reached.begin(), reached.end(), 1));
      asked += count;
      const auto all = static_cast<double>(effort.labellings + 1);
      if (static_cast<double>(as_bad) > significance * all) break;  // whatever the others say
    }
    family.exchange_p = static_cast<double>(as_bad) / static_cast<double>(asked);
    family.passed = asked <= effort.labellings || *family.exchange_p > significance;
  }

  const PictureShape& shape_;
  std::size_t actual_;
  std::size_t expected_;
  StatisticalSettings settings_;
  RegionRule rule_;
  PooledStack stack_;
  bool exchangeable_ = false;  ///< there are enough labellings to tell
  std::size_t few_ = 0;        ///< how many others are the fewest that do
  std::size_t many_ = 0;
};

void check_stack(const EstimateStack& stack) {
  if (stack.images.size() < 2) {
    throw std::invalid_argument(
        fmt::format("a stack of {} image(s), expected at least 2", stack.images.size()));
  }
  for (const auto& image : stack.images) check_planes(image, stack.shape);
}

}  // namespace

double StatisticalFamily::smallest_p() const { return std::exp(smallest_log_p); }

StatisticalResult test_stacks(const EstimateStack& actual, const EstimateStack& expected,
                              const StatisticalSettings& settings) {
  check_shapes(actual.shape, expected.shape, settings);
  check_stack(actual);
  check_stack(expected);
  return StackTests(actual, expected, settings).run();
}

}  // namespace lume::io
