// SPDX-License-Identifier: Apache-2.0
// What makes a comparison of two images meaningless. Tools that go on nonetheless let images of
// nothing but NaN pass, and cropped ones.
#pragma once

#include "io/compare/channel_image.h"

#include <string>

namespace lume::io {

/// Looked for in this order.
enum class Refusal { none, non_finite, size, data_window, channels };

struct RefusalReason {
  Refusal refusal = Refusal::none;
  std::string message;  ///< one line: what, in which file, what was expected
};

/// Images are matched by their place in the file, channels by their names.
[[nodiscard]] RefusalReason find_refusal(const ImageFile& actual, const ImageFile& expected);

}  // namespace lume::io
