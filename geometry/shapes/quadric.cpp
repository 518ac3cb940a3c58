// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/quadric.h"

#include "geometry/shapes/cylindrical_point.h"
#include "geometry/shapes/face.h"
#include "geometry/shapes/interval_functions.h"
#include "geometry/shapes/span.h"
#include "geometry/shapes/tight_box.h"

#include <array>
#include <cmath>

namespace lume::geometry {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

Interval times(double factor, const Interval& interval) {
  return factor == 0.0 ? Interval(0.0) : Interval(factor) * interval;
}

}  // namespace

Quadric::Quadric(const DMat4& q, const DVec3& lower, const DVec3& upper, bool caps)
    : squares_(q),
      linear_(q[3]),
      constant_(q[3][3]),
      lower_(lower),
      upper_(upper),
      caps_(caps),
      tight_lower_(lower),
      tight_upper_(upper) {
  find_ellipsoid();
  if (!is_whole_ellipsoid_) find_bounds();
}

double Quadric::value(const DVec3& p) const {
  return dot(p, squares_ * p + 2.0 * linear_) + constant_;
}

/// With F = (p - m).A(p - m) - s and A positive definite the surface is an ellipsoid around m, and
/// reaches sqrt(s d.(A^-1 d)) from there along d.
void Quadric::find_ellipsoid() {
  DMat3 a = squares_;
  const double sign = a[0][0] < 0.0 ? -1.0 : 1.0;
  a *= sign;
  const double minor = a[0][0] * a[1][1] - a[1][0] * a[1][0];
  const double determinant = glm::determinant(a);
  const double size = a[0][0] * a[1][1] * a[2][2];
  if (!(a[0][0] > 0.0 && minor > 0.0 && determinant > 1e-9 * size)) return;
  const DMat3 inverse = glm::inverse(a);
  const DVec3 center = -(inverse * (sign * linear_));
  const double s = -sign * (constant_ + dot(linear_, center));
  // A cap-closed solid whose inside is out there (sign < 0) is the box with a hole.
  if (!(s >= 0.0) || (caps_ && sign < 0.0)) return;
  ellipsoid_ = s * inverse;
  // A little more, for what the inverse is off.
  const DVec3 reach =
      (1.0 + 1e-9) * glm::sqrt(DVec3(ellipsoid_[0][0], ellipsoid_[1][1], ellipsoid_[2][2]));
  if (!(is_in_box(center - reach) && is_in_box(center + reach))) return;
  tight_lower_ = center - reach;
  tight_upper_ = center + reach;
  middle_ = center;
  size_ = length(reach);
  is_whole_ellipsoid_ = true;
}

void Quadric::find_bounds() {
  const auto may_contain = [this](const DVec3& lower, const DVec3& upper) {
    const Interval x(lower.x, upper.x);
    const Interval y(lower.y, upper.y);
    const Interval z(lower.z, upper.z);
    const DMat3& a = squares_;
    const Interval f = times(a[0][0], power(x, 2)) + times(a[1][1], power(y, 2)) +
                       times(a[2][2], power(z, 2)) + times(2.0 * a[1][0], x * y) +
                       times(2.0 * a[2][0], x * z) + times(2.0 * a[2][1], y * z) +
                       times(2.0 * linear_.x, x) + times(2.0 * linear_.y, y) +
                       times(2.0 * linear_.z, z) + Interval(constant_);
    return f.lower <= 0.0 && (caps_ || f.upper >= 0.0);
  };
  // An open side may still have an end: it is looked for in a box that is larger than any scene.
  constexpr double k_far = 1e9;
  const DBounds box =
      tight_box({glm::max(lower_, DVec3(-k_far)), glm::min(upper_, DVec3(k_far))}, may_contain)
          .value_or(DBounds{DVec3(0.0), DVec3(0.0)});  // nothing is there
  for (int i = 0; i < 3; ++i) {
    tight_lower_[i] =
        std::isinf(lower_[i]) && box.lower[i] < -0.5 * k_far ? -k_infinity : box.lower[i];
    tight_upper_[i] =
        std::isinf(upper_[i]) && box.upper[i] > 0.5 * k_far ? k_infinity : box.upper[i];
    const double middle = 0.5 * (tight_lower_[i] + tight_upper_[i]);
    middle_[i] = std::isfinite(middle) ? middle : 0.0;
  }
  const double size = length(tight_upper_ - tight_lower_);
  if (std::isfinite(size)) size_ = size;
}

double Quadric::support(const DVec3& direction) const {
  if (is_whole_ellipsoid_) {
    return dot(middle_, direction) + std::sqrt(dot(direction, ellipsoid_ * direction));
  }
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    if (direction[i] != 0.0) {
      sum += direction[i] * (direction[i] > 0.0 ? tight_upper_[i] : tight_lower_[i]);
    }
  }
  return sum;
}

std::optional<Crossing> Quadric::intersect_solid(const ObjectRay& ray, const Along& line) const {
  Span box;
  for (int axis = 0; axis < 3; ++axis) {
    box = intersection(box, slab(line.origin, ray.direction, axis, lower_[axis], upper_[axis],
                                 first_cap + 2 * static_cast<std::uint32_t>(axis)));
  }
  if (box.is_empty() || std::isnan(line.b + line.c)) return std::nullopt;
  // The line is inside where a t^2 + 2 b t + c <= 0: between the roots, or before the first and
  // after the second.
  std::array<Span, 2> inside;
  int count = 1;
  if (std::isnan(line.first)) {
    if (line.c > 0.0) return std::nullopt;
  } else if (line.a > 0.0) {
    inside[0] = {line.first, line.second};
  } else if (line.a == 0.0) {
    const double root = std::isfinite(line.first) ? line.first : line.second;
    (line.b > 0.0 ? inside[0].leave : inside[0].enter) = root;
  } else {
    inside[0].leave = line.first;
    inside[1].enter = line.second;
    count = 2;
  }
  for (int i = 0; i < count; ++i) {
    const Span part = intersection(box, inside[static_cast<std::size_t>(i)]);
    if (const auto crossing = first_end(shifted(part, line.t), ray)) return crossing;
  }
  return std::nullopt;
}

ShapePoint Quadric::point(const DVec3& near, const Crossing& crossing) const {
  if (crossing.part != side) {
    DVec3 lower = lower_;
    DVec3 upper = upper_;
    for (int i = 0; i < 3; ++i) {
      if (std::isinf(lower[i])) lower[i] = tight_lower_[i];
      if (std::isinf(upper[i])) upper[i] = tight_upper_[i];
    }
    return face_point(near, crossing.part - first_cap, lower, upper);
  }
  const DVec3 g = gradient(near);
  const double size = dot(g, g);
  const DVec3 on_surface = size > 0.0 ? near - value(near) / size * g : near;
  // An image is as high as the box that was asked for, else as the surface.
  const double bottom = std::isfinite(lower_.y) ? lower_.y : tight_lower_.y;
  const double top = std::isfinite(upper_.y) ? upper_.y : tight_upper_.y;
  return cylindrical_point(on_surface, gradient(on_surface), bottom, top);
}

DMat4 quadric_matrix(QuadricForm form, const DVec3& semi_axes, double waist) {
  const double w2 = waist * waist;
  DMat4 q(0.0);  // of X, Y, Z
  q[0][0] = q[2][2] = 1.0;
  switch (form) {
    case QuadricForm::ellipsoid:
      q[1][1] = 1.0;
      q[3][3] = -1.0;
      break;
    case QuadricForm::cylinder:
      q[3][3] = -1.0;
      break;
    case QuadricForm::cone:
      q[1][1] = -0.25;
      q[3][1] = q[1][3] = 0.25;
      q[3][3] = -0.25;
      break;
    case QuadricForm::paraboloid:
      q[3][1] = q[1][3] = -0.25;
      q[3][3] = -0.5;
      break;
    case QuadricForm::hyperboloid_one_sheet:
      q[1][1] = w2 - 1.0;
      q[3][3] = -w2;
      break;
    case QuadricForm::hyperboloid_two_sheets:
      q[0][0] = q[2][2] = 1.0 - w2;
      q[1][1] = -1.0;
      q[3][3] = w2;
      break;
  }
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 4; ++k) {
      q[i][k] /= semi_axes[i];
      q[k][i] /= semi_axes[i];
    }
  }
  return q;
}

}  // namespace lume::geometry
