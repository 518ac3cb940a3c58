// SPDX-License-Identifier: Apache-2.0
// The colours of FLIP (Andersson and others 2020). In double precision, for
// differences between colours that are nearly equal are raised to powers below 1.
#pragma once

#include <array>

namespace lume::io {

using Triple = std::array<double, 3>;

/// The opponent space YCxCz without its scales and offset, which no filter of weight 1 feels:
/// Y, X - Y and Y - Z, each of X, Y and Z in units of what white has.
[[nodiscard]] Triple to_opponent(const Triple& linear_rgb);

/// L*a*b* with a* and b* after Hunt's adjustment, of an opponent colour that is
/// clamped to those a display has.
[[nodiscard]] Triple to_hunt_lab(const Triple& opponent);

/// The error that colours alone make, in [0, 1]: HyAB's distance of two colours of
/// to_hunt_lab, raised to a power and spread so that small ones have most of the range.
[[nodiscard]] double color_error(const Triple& reference, const Triple& test);

/// Both errors together: `features` in [0, 1] makes `color` stand out more.
[[nodiscard]] double combined_error(double color, double features);

/// The largest power of a distance, that of green to blue: c_max of the paper.
[[nodiscard]] double largest_color_distance();

}  // namespace lume::io
