// SPDX-License-Identifier: Apache-2.0
// If both stacks come from one distribution, whatever it is, it does not matter which image belongs
// to which: a failure that is no accident is one that hardly any other assignment shows. This gives
// a permutation test of the worst of all tests (Westfall and Young 1993, "Resampling-Based Multiple
// Testing", section 2.6), whose significance is exact for skewed and dependent pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lume::io {

/// Indices of the images, actual ones first, that are taken for the actual ones; ascending.
using Labels = std::vector<std::uint32_t>;

/// The assignment as it is: 0 ... actual - 1.
[[nodiscard]] Labels true_labels(std::size_t actual);

/// How many assignments there are that can give different results, or `limit` if more: to swap
/// stacks of the same size changes nothing.
[[nodiscard]] std::size_t count_labellings(std::size_t actual, std::size_t expected,
                                           std::size_t limit);

/// `count` different assignments other than the true one, of which there must be enough. The same
/// ones each time.
[[nodiscard]] std::vector<Labels> draw_labellings(std::size_t actual, std::size_t expected,
                                                  std::size_t count);

}  // namespace lume::io
