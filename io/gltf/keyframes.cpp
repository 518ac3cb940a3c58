// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/keyframes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace lume::io::gltf {
namespace {

using Row = std::vector<double>;

enum class Part : std::size_t { in_tangent, value, out_tangent };

Row row(const Keyframes& keyframes, std::size_t key, Part part = Part::value) {
  const bool has_tangents = keyframes.interpolation == Interpolation::cubic_spline;
  const std::size_t index = has_tangents ? 3 * key + static_cast<std::size_t>(part) : key;
  const auto begin =
      keyframes.values.begin() + static_cast<std::ptrdiff_t>(index * keyframes.width);
  return {begin, begin + static_cast<std::ptrdiff_t>(keyframes.width)};
}

/// fa a + fb b
Row blend(double fa, const Row& a, double fb, const Row& b) {
  Row result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    result[i] = fa * a[i] + fb * b[i];
  }
  return result;
}

Row normalized(Row q) {
  const double length = std::sqrt(std::inner_product(q.begin(), q.end(), q.begin(), 0.0));
  if (!(length > 0.0) || !std::isfinite(length)) {
    return {0.0, 0.0, 0.0, 1.0};
  }
  for (double& number : q) {
    number /= length;
  }
  return q;
}

/// Shoemake, "Animating rotation with quaternion curves", 1985, along the shorter of the two ways.
/// The angle is taken from sine and cosine: acos alone loses half the digits of small angles.
Row slerp(const Row& a, Row b, double s) {
  double cosine = std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  if (cosine < 0.0) {
    b = blend(-1.0, b, 0.0, b);
    cosine = -cosine;
  }
  const Row aside = blend(1.0, b, -cosine, a);  // b without what it shares with a
  const double sine = std::sqrt(std::inner_product(aside.begin(), aside.end(), aside.begin(), 0.0));
  if (!(sine > 0.0)) {
    return a;
  }
  const double angle = s * std::atan2(sine, cosine);
  return normalized(blend(std::cos(angle), a, std::sin(angle) / sine, aside));
}

/// Between keys `k` and `k + 1`, `s` of the way (glTF 2.0, appendix C.5: a cubic Hermite spline
/// whose tangents are scaled by the length of the interval).
Row spline(const Keyframes& keyframes, std::size_t k, double s) {
  const double interval = keyframes.times[k + 1] - keyframes.times[k];
  const double s2 = s * s;
  const double s3 = s2 * s;
  const Row values = blend(2.0 * s3 - 3.0 * s2 + 1.0, row(keyframes, k), 3.0 * s2 - 2.0 * s3,
                           row(keyframes, k + 1));
  const Row tangents = blend(interval * (s3 - 2.0 * s2 + s), row(keyframes, k, Part::out_tangent),
                             interval * (s3 - s2), row(keyframes, k + 1, Part::in_tangent));
  return blend(1.0, values, 1.0, tangents);
}

Row between(const Keyframes& keyframes, std::size_t k, double s) {
  switch (keyframes.interpolation) {
    case Interpolation::step:
      break;
    case Interpolation::linear:
      if (keyframes.is_rotation) {
        return slerp(normalized(row(keyframes, k)), normalized(row(keyframes, k + 1)), s);
      }
      return blend(1.0 - s, row(keyframes, k), s, row(keyframes, k + 1));
    case Interpolation::cubic_spline:
      return spline(keyframes, k, s);
  }
  return row(keyframes, k);
}

}  // namespace

std::vector<double> sample(const Keyframes& keyframes, double time) {
  const std::vector<double>& times = keyframes.times;
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  Row result;
  if (after == times.begin() || after == times.end()) {
    result = row(keyframes, after == times.begin() ? 0 : times.size() - 1);
  } else {
    const auto k = static_cast<std::size_t>(after - times.begin()) - 1;
    result = between(keyframes, k, (time - times[k]) / (times[k + 1] - times[k]));
  }
  return keyframes.is_rotation ? normalized(std::move(result)) : result;
}

}  // namespace lume::io::gltf
