// SPDX-License-Identifier: Apache-2.0
// What an animated property is at a time: the three interpolations of glTF 2.0, appendix C. It
// knows numbers only; where they come from and where they go is not asked here.
#pragma once

#include <cstddef>
#include <vector>

namespace lume::io::gltf {

enum class Interpolation { step, linear, cubic_spline };

/// Keyframes of one property, a row of `width` numbers a key. Times are in seconds, finite and
/// strictly increasing, and there is at least one; of a cubic spline each key has three rows: the
/// tangent into it, the value, and the tangent out of it, both a second.
struct Keyframes {
  Interpolation interpolation = Interpolation::linear;
  bool is_rotation = false;  ///< rows are unit quaternions x, y, z, w
  std::size_t width = 0;
  std::vector<double> times;
  std::vector<double> values;
};

/// The row at `time`; before the first key and after the last it is that key's. Rotations come
/// normalized, or as the identity if they have no direction.
[[nodiscard]] std::vector<double> sample(const Keyframes& keyframes, double time);

}  // namespace lume::io::gltf
