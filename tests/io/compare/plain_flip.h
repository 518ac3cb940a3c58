// SPDX-License-Identifier: Apache-2.0
// FLIP and HDR-FLIP as the papers write them, with two-dimensional filters and nothing shared with
// what is tested. Only for small pictures.
#pragma once

#include "io/compare/rgb_image.h"

#include <vector>

namespace lume::tests {

/// Andersson and others 2020, of linear values.
[[nodiscard]] std::vector<double> plain_flip(const io::RgbImage& reference,
                                             const io::RgbImage& test, double pixels_per_degree);

/// Andersson and others 2021, of values >= 0 of which the reference's median is not 0.
[[nodiscard]] std::vector<double> plain_flip_hdr(const io::RgbImage& reference,
                                                 const io::RgbImage& test,
                                                 double pixels_per_degree);

}  // namespace lume::tests
