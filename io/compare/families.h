// SPDX-License-Identifier: Apache-2.0
// What the tests of stacks and those of moments have in common: checks of their input, and how the
// families of tests share the significance.
#pragma once

#include "io/compare/estimates.h"
#include "io/compare/statistical_test.h"

#include <cstddef>
#include <vector>

namespace lume::io {

/// What each of the three families of tests may contribute to the false alarms.
[[nodiscard]] double family_significance(const StatisticalSettings& settings);

/// A result with the families' sizes and thresholds, by Bonferroni's correction: it holds however
/// tests depend on each other.
[[nodiscard]] StatisticalResult make_result(const PictureShape& shape, std::size_t tiles,
                                            const StatisticalSettings& settings);

/// Throws std::invalid_argument if the sides differ, the picture is empty or a setting is no good.
void check_shapes(const PictureShape& actual, const PictureShape& expected,
                  const StatisticalSettings& settings);

/// Throws std::invalid_argument unless there is a plane of finite values for each channel.
void check_planes(const std::vector<std::vector<float>>& planes, const PictureShape& shape);

}  // namespace lume::io
