// SPDX-License-Identifier: Apache-2.0
// The operations of kernel.h one number at a time: for processors without AVX2, and the reference
// that the others are tested against.
#pragma once

#include "geometry/accelerators/wide/kernel.h"

#include <array>

namespace lume::geometry::wide {

struct Scalar {
  using Double4 = std::array<double, 4>;

  template <class Operation>
  static Double4 each(const Double4& a, const Double4& b, const Operation& operation) {
    return {operation(a[0], b[0]), operation(a[1], b[1]), operation(a[2], b[2]),
            operation(a[3], b[3])};
  }
  template <class Condition>
  static unsigned mask_where(const Condition& condition) {
    unsigned mask = 0;
    for (unsigned lane = 0; lane < 4; ++lane) mask |= condition(lane) ? 1u << lane : 0u;
    return mask;
  }

  static Double4 set(double x) { return {x, x, x, x}; }
  static Double4 widen(const float* x) { return {x[0], x[1], x[2], x[3]}; }
  static Double4 load(const double* x) { return {x[0], x[1], x[2], x[3]}; }
  static void store(double* to, const Double4& x) {
    for (unsigned lane = 0; lane < 4; ++lane) to[lane] = x[lane];
  }
  static Double4 add(const Double4& a, const Double4& b) {
    return each(a, b, [](double x, double y) { return x + y; });
  }
  static Double4 sub(const Double4& a, const Double4& b) {
    return each(a, b, [](double x, double y) { return x - y; });
  }
  static Double4 mul(const Double4& a, const Double4& b) {
    return each(a, b, [](double x, double y) { return x * y; });
  }
  static Double4 div(const Double4& a, const Double4& b) {
    return each(a, b, [](double x, double y) { return x / y; });
  }

  /// Where no two of three numbers have different signs; zeros have none.
  static unsigned same_sign(const Double4& a, const Double4& b, const Double4& c) {
    return mask_where([&](unsigned i) {
      return (a[i] >= 0.0 && b[i] >= 0.0 && c[i] >= 0.0) ||
             (a[i] <= 0.0 && b[i] <= 0.0 && c[i] <= 0.0);
    });
  }
  static unsigned not_zero(const Double4& x) {
    return mask_where([&](unsigned i) { return x[i] < 0.0 || x[i] > 0.0; });
  }
  static unsigned between(const Double4& x, double low, double high) {
    return mask_where([&](unsigned i) { return x[i] >= low && x[i] <= high; });
  }

  static void prepare(const TreeRay& ray, const float (&farthest)[4], Reciprocal& result) {
    result.scale = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      result.scale = std::fmax(result.scale, std::fabs(ray.direction[axis]));
    }
    for (int axis = 0; axis < 3; ++axis) {
      const double d = ray.direction[axis] / result.scale;
      const double inverse =
          1.0 / std::copysign(std::fmax(std::fabs(d), Reciprocal::k_flattest), d);
      const double size = std::fabs(ray.origin[axis]) + static_cast<double>(farthest[axis]);
      const double slack = Reciprocal::k_rounding * size * std::fabs(inverse);
      const double offset = -ray.origin[axis] * inverse;
      result.inverse[axis] = static_cast<float>(inverse);
      result.near_offset[axis] = static_cast<float>(offset - slack);
      result.far_offset[axis] = static_cast<float>(offset + slack);
    }
  }

  using Float8 = std::array<float, k_width>;

  static Float8 fill(float x) { return {x, x, x, x, x, x, x, x}; }
  template <class Operation>
  static Float8 each_of_8(const Operation& operation) {
    Float8 result{};
    for (unsigned lane = 0; lane < k_width; ++lane) result[lane] = operation(lane);
    return result;
  }
  static Float8 load(const float* x) { return {x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]}; }
  static Float8 add(const Float8& a, const Float8& b) {
    return each_of_8([&](unsigned i) { return a[i] + b[i]; });
  }
  static Float8 mul(const Float8& a, const Float8& b) {
    return each_of_8([&](unsigned i) { return a[i] * b[i]; });
  }
  static Float8 fma(const Float8& a, const Float8& b, const Float8& c) {
    return each_of_8([&](unsigned i) { return a[i] * b[i] + c[i]; });
  }
  static Float8 min(const Float8& a, const Float8& b) {
    return each_of_8([&](unsigned i) { return a[i] < b[i] ? a[i] : b[i]; });
  }
  static Float8 max(const Float8& a, const Float8& b) {
    return each_of_8([&](unsigned i) { return a[i] > b[i] ? a[i] : b[i]; });
  }
  static void store(float* to, const Float8& x) {
    for (unsigned lane = 0; lane < k_width; ++lane) to[lane] = x[lane];
  }
  static unsigned not_above(const Float8& a, const Float8& b) {
    unsigned mask = 0;
    for (unsigned i = 0; i < k_width; ++i) mask |= a[i] <= b[i] ? 1u << i : 0u;
    return mask;
  }

  struct ManyFloats;
  struct ManyDoubles;
};

struct Scalar::ManyFloats : Scalar {
  static constexpr unsigned k_size = 8;
};
struct Scalar::ManyDoubles : Scalar {
  static constexpr unsigned k_size = 4;
};

}  // namespace lume::geometry::wide
