// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/test_judge.h"

#include "io/compare/statistical_test.h"
#include "io/image_tests/stack_file.h"
#include "renderer/cli/comparison_words.h"

#include <fmt/format.h>

#include <utility>

namespace lume::cli {
namespace {

Judgement judge_pixels(const io::TestCase& test, const io::ImageFile& actual,
                       const io::ImageFile& expected) {
  io::CompareSettings settings = test.compare;
  if (test.tier == io::Tier::exact) settings.limits = {};
  io::Comparison comparison = io::compare_images(actual, expected, settings);
  Judgement judgement;
  judgement.identical = comparison.identical();
  if (comparison.refusal != io::Refusal::none) {
    judgement.message = comparison.message;
    return judgement;
  }
  judgement.passed = test.tier == io::Tier::exact ? comparison.identical() : comparison.passed;
  if (!judgement.passed) judgement.message = why_failed(comparison);
  judgement.metrics = std::move(comparison.verdicts);
  judgement.flip_map = std::move(comparison.flip_map);
  judgement.color_image = comparison.color_image;
  return judgement;
}

io::MetricVerdict family_metric(const char* name, const io::StatisticalFamily& family) {
  return {fmt::format("p of the worst {}", name), family.smallest_p(), family.threshold, true,
          !family.passed};
}

void add_bias(std::vector<io::MetricVerdict>& metrics, const char* what,
              const std::optional<double>& bias) {
  if (bias)
    metrics.push_back({fmt::format("bias of the {} it sees", what), *bias, {}, false, false});
}

/// Images of other seeds have the same expectation.
Judgement judge_statistically(const io::TestCase& test, const io::ImageFile& actual,
                              const io::ImageFile& expected) {
  const io::EstimateStack stack = io::stack_of(actual);
  const io::EstimateStack reference = io::stack_of(expected);
  const bool is_alike = stack.shape.width == reference.shape.width &&
                        stack.shape.height == reference.shape.height &&
                        stack.shape.channels == reference.shape.channels;
  Judgement judgement;
  if (!is_alike) {
    judgement.message = "the images are not those of the reference in size or channels";
    return judgement;
  }
  io::StatisticalSettings settings;
  settings.significance = test.significance;
  const io::StatisticalResult result = io::test_stacks(stack, reference, settings);
  judgement.passed = result.passed;
  judgement.message = io::describe(result);
  judgement.metrics = {family_metric("pixel", result.pixels), family_metric("tile", result.tiles),
                       family_metric("channel", result.image)};
  add_bias(judgement.metrics, "median tile", result.tiles.detectable_bias);
  add_bias(judgement.metrics, "whole image", result.image.detectable_bias);
  return judgement;
}

}  // namespace

Judgement judge(const io::TestCase& test, const io::ImageFile& actual,
                const io::ImageFile& expected) {
  return test.tier == io::Tier::statistical ? judge_statistically(test, actual, expected)
                                            : judge_pixels(test, actual, expected);
}

}  // namespace lume::cli
