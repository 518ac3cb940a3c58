// SPDX-License-Identifier: Apache-2.0
// The judge of a shape's answers: an oracle, and the little that rounding may decide.
#pragma once

#include "geometry/shapes/shape.h"
#include "tests/geometry/shapes/oracles.h"
#include "tests/support/random.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

namespace lume::geometry {

using test::Oracle;
using test::OracleCrossing;
using test::Random;
using test::RealRay;

struct ShapeCase {
  std::string name;
  Shape shape;
  Oracle oracle;
  double size = 1.0;  ///< about the shape's radius
  bool is_bounded = true;
  bool has_coordinates = true;  ///< false where u does not change along the surface
  int ray_kinds = 5;            ///< how many of make_ray()'s
};
inline std::ostream& operator<<(std::ostream& out, const ShapeCase& shape_case) {
  return out << shape_case.name;
}

/// One of the kinds of rays that there are; `on_surface` is a point of the shape.
inline ObjectRay make_ray(Random& random, double size, const ShapePoint& on_surface, int kind) {
  const DVec3 target = size * DVec3(random.cube(1.2f));
  const DVec3 direction(random.direction());
  ObjectRay ray;
  switch (kind) {
    case 0:  // from near by
      ray.origin = size * DVec3(random.cube(3.0f));
      ray.direction = target - ray.origin;
      break;
    case 1:  // from a million times its size away
      ray.origin = target - 1e6 * size * direction;
      ray.direction = direction;
      break;
    case 2:  // along an axis, or in a plane of two
      ray.origin = target;
      ray.direction[static_cast<int>(random.below(3))] = random.uniform() < 0.5f ? -1.0 : 1.0;
      ray.direction[static_cast<int>(random.below(3))] += random.uniform(-1.0f, 1.0f);
      ray.origin -= 3.0 * size * ray.direction;
      break;
    case 3:  // from the surface itself
      ray.origin = on_surface.position;
      ray.direction = direction;
      break;
    default: {  // touching the surface, or nearly so
      const DVec3 n = normalize(on_surface.normal);
      const DVec3 along = normalize(cross(n, direction));
      const double height = (random.uniform() < 0.5f ? -1.0 : 1.0) *
                            std::pow(10.0, static_cast<double>(random.uniform(-12.0f, -3.0f)));
      ray.origin = on_surface.position + size * (height * n - 2.0 * along);
      ray.direction = along;
    }
  }
  ray.direction *= std::pow(10.0, static_cast<double>(random.uniform(-3.0f, 3.0f)));
  return ray;
}

/// What the oracle's crossings, in order, say about the shape's answer.
enum class Verdict { right, wrong, marginal };

class Referee {
 public:
  Referee(const ShapeCase& shape_case, const ObjectRay& ray)
      : shape_(shape_case), ray_(ray), real_(ray) {
    // What a few roundings of the coordinates amount to (metres).
    slack_ = 1e-14 * (length(ray.origin) + shape_case.size);
  }

  [[nodiscard]] Verdict judge(const std::optional<Crossing>& answer) const {
    if (agrees(answer, crossings(0.0))) return Verdict::right;
    // The answer may be that to a shape which is larger or smaller by a rounding.
    for (const double slack : {slack_, -slack_}) {
      if (agrees(answer, crossings(slack))) return Verdict::marginal;
    }
    return Verdict::wrong;
  }

 private:
  [[nodiscard]] std::vector<OracleCrossing> crossings(double slack) const {
    auto found = shape_.oracle(real_, slack);
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
    return found;
  }

  /// The first of the crossings that lies on the ray must be the answer. Those which rounding may
  /// take for one side or the other of the ray's ends, or of each other, may be.
  [[nodiscard]] bool agrees(const std::optional<Crossing>& answer,
                            const std::vector<OracleCrossing>& expected) const {
    const double speed = length(ray_.direction);
    for (const OracleCrossing& crossing : expected) {
      const auto t = static_cast<double>(crossing.t);
      const double rounding = 10.0 * slack_ / speed;
      const double tolerance = 1e-5 * std::abs(t) + rounding;  // what is promised
      if (answer && std::abs(answer->t - t) <= tolerance) {
        if (is_normal(*answer, crossing)) return true;
        continue;
      }
      if (t >= ray_.t_min + rounding && t <= ray_.t_max - rounding) return false;
    }
    return !answer.has_value();
  }

  /// To 1e-4 rad, or where the surface bends more strongly than that within the tolerance of t.
  [[nodiscard]] bool is_normal(const Crossing& answer, const OracleCrossing& crossing) const {
    const DVec3 normal = normalize(shape_point(shape_.shape, ray_, answer).normal);
    if (length(crossing.normal) == 0.0) return true;  // an apex
    return length(cross(normal, normalize(crossing.normal))) < 1e-4 &&
           dot(normal, crossing.normal) > 0.0;
  }

  const ShapeCase& shape_;
  const ObjectRay& ray_;
  RealRay real_;
  double slack_;
};

}  // namespace lume::geometry
