// SPDX-License-Identifier: Apache-2.0
// What the tests of implicit surfaces share.
#pragma once

#include "geometry/shapes/implicit_surface.h"
#include "tests/support/random.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace lume::test {

using geometry::DVec3;
using geometry::ImplicitSurface;
using geometry::ObjectRay;

inline ImplicitSurface surface_of(const std::string& text, double half_size) {
  return {geometry::Expression(text), DVec3(-half_size), DVec3(half_size)};
}

inline ObjectRay ray_of(const DVec3& origin, const DVec3& direction) {
  return {.origin = origin, .direction = direction};
}

/// All crossings of a ray, each looked for behind the one before.
inline std::vector<double> all_crossings(const ImplicitSurface& surface, ObjectRay ray) {
  std::vector<double> found;
  while (found.size() < 100) {
    const auto crossing = surface.intersect(ray);
    if (!crossing) break;
    found.push_back(crossing->t);
    ray.t_min = std::nextafter(crossing->t, std::numeric_limits<double>::infinity());
  }
  return found;
}

/// A ray that starts outside of the box or in it, and goes through the box.
inline ObjectRay any_ray(Random& random, double half_size) {
  const DVec3 target = DVec3(random.cube(1.0f)) * half_size;
  const double away = random.below(3) == 0 ? 0.5 : 4.0;
  ObjectRay ray;
  ray.origin = DVec3(random.direction()) * half_size * away;
  ray.direction =
      (target - ray.origin) * std::exp2(static_cast<double>(random.uniform(-9.0f, 9.0f)));
  return ray;
}

}  // namespace lume::test
