// SPDX-License-Identifier: Apache-2.0
// Numbers as colours, for pictures of what is no light.
#pragma once

#include "shading/color.h"

namespace lume::cli {

/// 0 dark violet, 1 yellow, and equal steps between look equally large: a straight line in
/// lightness through the hues from violet over blue and green (in the manner of viridis, by van der
/// Walt and Smith 2015, from our own calculation in Oklab, Ottosson 2020). Scene-linear Rec.709; a
/// value outside of 0..1 counts as the nearer end.
[[nodiscard]] shading::Color sequential_color(float value);

/// -1 blue, 0 nearly white, 1 red, as dark at both ends.
[[nodiscard]] shading::Color diverging_color(float value);

}  // namespace lume::cli
