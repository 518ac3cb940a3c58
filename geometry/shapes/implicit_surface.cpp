// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/implicit_surface.h"

#include "geometry/shapes/cylindrical_point.h"
#include "geometry/shapes/root_isolator.h"
#include "geometry/shapes/span.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lume::geometry {
namespace {

// Of the box's size: a point on the box's side stays in the box in spite of its rounding.
constexpr double k_tolerance = 1e-12;
// The box in which roots are looked for is larger, so that no root lies at its very border.
constexpr double k_padding = 1e-9;

/// f along the line start + s * along.
struct AlongLine {
  const Expression& f;
  DVec3 start;
  DVec3 along;

  double operator()(double s) const {
    return f.evaluate(start.x + along.x * s, start.y + along.y * s, start.z + along.z * s);
  }
  Interval operator()(const Interval& s) const {
    return f.evaluate(coordinate(s, 0), coordinate(s, 1), coordinate(s, 2));
  }
  template <class T>
  Dual<T, 1> operator()(const Dual<T, 1>& s) const {
    const auto component = [&](int axis) {
      return Dual<T, 1>(coordinate(s.value, axis), {T(along[axis])});
    };
    return f.evaluate(component(0), component(1), component(2));
  }

 private:
  template <class T>
  [[nodiscard]] T coordinate(const T& s, int axis) const {
    return s * along[axis] + start[axis];
  }
};

/// False if interval arithmetic proves that f has no root in the box: by its value, or by the mean
/// value theorem, f(p) in f(m) + grad f(box) . (p - m). Along an axis on which f is monotone the
/// latter also says how much of the box can be cut off (a step of the interval Newton method).
bool may_have_root(const Expression& f, DVec3& lower, DVec3& upper) {
  using Number = Dual<Interval, 3>;
  const Interval zero(0.0);
  const Interval one(1.0);
  const std::array<Interval, 3> box = {Interval(lower.x, upper.x), Interval(lower.y, upper.y),
                                       Interval(lower.z, upper.z)};
  if (!f.evaluate(box[0], box[1], box[2]).contains(0.0)) return false;  // the cheap test first
  const Number value =
      f.evaluate(Number(box[0], {one, zero, zero}), Number(box[1], {zero, one, zero}),
                 Number(box[2], {zero, zero, one}));
  const DVec3 m = 0.5 * lower + 0.5 * upper;
  const Interval at_middle = f.evaluate(Interval(m.x), Interval(m.y), Interval(m.z));
  if (at_middle.is_empty()) return true;  // the middle has no value, but other points have
  std::array<Interval, 3> change{};       // of f, from the middle along each axis
  for (std::size_t i = 0; i < 3; ++i)
    change[i] = value.slope[i] * (box[i] + -m[static_cast<int>(i)]);
  if (!(at_middle + change[0] + change[1] + change[2]).contains(0.0)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(value.slope[i].lower > 0.0 || value.slope[i].upper < 0.0)) continue;
    const int axis = static_cast<int>(i);
    const Interval others = at_middle + change[(i + 1) % 3] + change[(i + 2) % 3];
    const Interval root = -others / value.slope[i] + m[axis];
    lower[axis] = std::max(lower[axis], root.lower);
    upper[axis] = std::min(upper[axis], root.upper);
    if (lower[axis] > upper[axis]) return false;
  }
  return true;
}

DBounds padded(const DBounds& box, const DVec3& by) { return {box.lower - by, box.upper + by}; }

}  // namespace

ImplicitSurface::ImplicitSurface(Expression f, const DVec3& lower, const DVec3& upper)
    : f_(std::move(f)), box_{lower, upper} {
  const auto tight =
      tight_box(box_, [this](DVec3& low, DVec3& high) { return may_have_root(f_, low, high); });
  const DVec3 middle = box_.center();
  tight_ = padded(tight.value_or(DBounds{middle, middle}), k_padding * box_.size());
  is_empty_ = !tight;
}

double ImplicitSurface::support(const DVec3& direction) const {
  const DVec3 farthest = max(direction * tight_.lower, direction * tight_.upper);
  return farthest.x + farthest.y + farthest.z;
}

std::optional<Crossing> ImplicitSurface::intersect(const ObjectRay& ray) const {
  // Roots are isolated in all of the box, not in the ray's part of it: so they are the same for all
  // rays along a line, and what follows a crossing is found behind it.
  const Span span = box_span(ray.origin, ray.direction, tight_, 0);
  const double width = span.leave - span.enter;
  // Infinite for a ray without direction; not a number if the ray has such.
  const bool is_stretch = width > 0.0 && std::isfinite(width + dot(ray.origin, ray.direction));
  if (is_empty_ || !is_stretch || !(span.enter <= ray.t_max && span.leave >= ray.t_min)) {
    return std::nullopt;
  }
  const auto to_t = [&](double s) { return span.enter + s * width; };
  const AlongLine line{f_, ray.at(span.enter), width * ray.direction};
  const DBounds box = padded(box_, k_tolerance * box_.size());
  const auto accept = [&](double s) {
    return ray.contains(to_t(s)) && box.contains(line.start + s * line.along);
  };
  const auto skip = [&](double begin, double end) {
    return to_t(end) < ray.t_min || to_t(begin) > ray.t_max;
  };
  const auto s = RootIsolator<AlongLine>(line).first(accept, skip);
  if (!s) return std::nullopt;
  return Crossing{.t = to_t(*s)};
}

ShapePoint ImplicitSurface::point(const DVec3& near, const Crossing& /*crossing*/) const {
  DVec3 position = near;
  DVec3 gradient(0.0, 0.0, 0.0);
  const double longest_step = 1e-3 * length(box_.size());
  for (int step = 0; step < 3; ++step) {
    const auto f = f_.with_gradient(position.x, position.y, position.z);
    const DVec3 slope(f.slope[0], f.slope[1], f.slope[2]);
    const double steepness = dot(slope, slope);
    if (!(steepness > 0.0 && std::isfinite(steepness))) break;  // a singular point
    gradient = slope;
    const DVec3 move = -f.value / steepness * slope;
    if (step == 2 || !(length(move) < longest_step)) break;
    position += move;
  }
  return cylindrical_point(position, gradient, box_.lower.y, box_.upper.y);
}

}  // namespace lume::geometry
