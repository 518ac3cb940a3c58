// SPDX-License-Identifier: Apache-2.0
// The image of a case held against its reference, by the case's tier.
#pragma once

#include "io/compare/comparison.h"
#include "io/image_tests/manifest.h"

#include <cstddef>
#include <string>
#include <vector>

namespace lume::cli {

struct Judgement {
  bool passed = false;
  bool identical = false;  ///< in every pixel
  std::string message;     ///< in one line: why not, or how far the verdict can be trusted
  std::vector<io::MetricVerdict> metrics;
  std::vector<float> flip_map;  ///< of the image's pixels; empty if there is none
  std::size_t color_image = 0;  ///< which of the file's images that is
};

/// Throws io::Error for a stack that is none.
[[nodiscard]] Judgement judge(const io::TestCase& test, const io::ImageFile& actual,
                              const io::ImageFile& expected);

}  // namespace lume::cli
