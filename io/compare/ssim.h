// SPDX-License-Identifier: Apache-2.0
// Structural similarity: Wang, Bovik, Sheikh and Simoncelli 2004, "Image Quality Assessment: From
// Error Visibility to Structural Similarity".
#pragma once

#include "io/compare/rgb_image.h"

namespace lume::io {

/// The mean over all pixels of SSIM (equation 13) of the luma (ITU-R BT.709) of both images,
/// encoded as sRGB and clamped to [0, 1]. Windows are Gaussian, 11 x 11 with a standard deviation
/// of 1.5 pixels (section III-B); beyond the border the image is taken to be mirrored. 1 for equal
/// images. Both are of one size.
[[nodiscard]] double ssim(const RgbImage& actual, const RgbImage& expected);

}  // namespace lume::io
