// SPDX-License-Identifier: Apache-2.0
// 113-bit arithmetic for oracles: with twice a double's digits the plainest formula is exact
// enough.
#pragma once

#include "geometry/crossing.h"

#include <array>
#include <cmath>

namespace lume::test {

__extension__ using Real = __float128;

[[nodiscard]] inline Real square_root(Real x) {
  if (!(x > 0)) return 0;
  Real root = std::sqrt(static_cast<double>(x));
  for (int i = 0; i < 2; ++i) root = (root + x / root) / 2;  // Newton: 53, 106, 113 bits
  return root;
}

[[nodiscard]] inline Real magnitude(Real x) { return x < 0 ? -x : x; }

struct RealVector {
  Real x = 0;
  Real y = 0;
  Real z = 0;

  RealVector() = default;
  RealVector(Real right, Real up, Real back) : x(right), y(up), z(back) {}
  explicit RealVector(const geometry::DVec3& v) : x(v.x), y(v.y), z(v.z) {}

  friend RealVector operator+(const RealVector& a, const RealVector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend RealVector operator-(const RealVector& a, const RealVector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend RealVector operator*(Real s, const RealVector& v) { return {s * v.x, s * v.y, s * v.z}; }
  [[nodiscard]] Real operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  [[nodiscard]] geometry::DVec3 rounded() const {
    return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  }
};

[[nodiscard]] inline Real dot(const RealVector& a, const RealVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

[[nodiscard]] inline RealVector cross(const RealVector& a, const RealVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct RealRay {
  explicit RealRay(const geometry::ObjectRay& ray) : origin(ray.origin), direction(ray.direction) {}
  [[nodiscard]] RealVector at(Real t) const { return origin + t * direction; }

  RealVector origin;
  RealVector direction;
};

}  // namespace lume::test
