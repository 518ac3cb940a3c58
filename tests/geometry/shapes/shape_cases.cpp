// SPDX-License-Identifier: Apache-2.0
#include "tests/geometry/shapes/shape_cases.h"

#include "tests/geometry/shapes/oracles.h"

#include <array>
#include <limits>

namespace lume::geometry {
namespace {

DMat4 symmetric(const std::array<double, 10>& upper) {
  DMat4 q;
  std::size_t next = 0;
  for (int i = 0; i < 4; ++i) {
    for (int k = i; k < 4; ++k) q[i][k] = q[k][i] = upper[next++];
  }
  return q;
}

ShapeCase quadric_case(const std::string& name, const DMat4& q, const DVec3& clip, bool caps,
                       double gradient = 2.0) {
  return {name, Quadric(q, -clip, clip, caps), test::quadric_oracle(q, -clip, clip, caps, gradient),
          length(clip)};
}

/// A star in a tilted plane with two holes, one of which touches a corner of the other.
ShapeCase polygon_case() {
  const DVec3 right = normalize(DVec3(1.0, 0.2, -0.4));
  const DVec3 up = normalize(cross(DVec3(0.3, 0.5, 0.8), right));
  const DVec3 middle(0.1, -0.05, 0.2);
  const auto at = [&](double x, double y) { return middle + x * right + y * up; };
  std::vector<std::vector<DVec3>> loops(3);
  for (int i = 0; i < 14; ++i) {
    const double radius = i % 2 == 0 ? 1.0 : 0.45;
    const double angle = k_turn * i / 14.0;
    loops[0].push_back(at(radius * std::cos(angle), radius * std::sin(angle)));
  }
  loops[1] = {at(-0.2, -0.2), at(0.1, -0.2), at(0.1, 0.1), at(-0.05, -0.1), at(-0.2, 0.1)};
  loops[2] = {at(0.1, 0.1), at(0.3, 0.1), at(0.2, 0.3)};
  return {"polygon", Polygon(loops), test::polygon_oracle(loops, cross(right, up))};
}

std::vector<ShapeCase> plain_cases() {
  constexpr double k_open = std::numeric_limits<double>::infinity();
  return {
      {"plane", Plane{}, test::rectangle_oracle(k_open, k_open), 1.0, false},
      {"rectangle", Plane{2.0, 0.5}, test::rectangle_oracle(2.0, 0.5)},
      {"disk", Disk{1.0, 0.0}, test::disk_oracle(1.0, 0.0)},
      {"ring", Disk{1.0, 0.6}, test::disk_oracle(1.0, 0.6)},
      {"box", Box{{0.5, 1.0, 0.1}}, test::box_oracle({0.5, 1.0, 0.1})},
      {"sphere", Sphere{1.0}, test::sphere_oracle(1.0)},
      {"tiny_sphere", Sphere{1e-6}, test::sphere_oracle(1e-6), 1e-6},
      {"huge_sphere", Sphere{6.4e6}, test::sphere_oracle(6.4e6), 6.4e6},
      {"cylinder", Cylinder{2.0, 0.5, 0.5}, test::cylinder_oracle(2.0, 0.5, 0.5)},
      {"tapered_cylinder", Cylinder{1.0, 0.25, 0.75}, test::cylinder_oracle(1.0, 0.25, 0.75)},
      {"cone", Cylinder{1.5, 1.0, 0.0}, test::cylinder_oracle(1.5, 1.0, 0.0), 1.2},
      {"capsule", Capsule(1.0, 0.5, 0.5), test::capsule_oracle(1.0, 0.5, 0.5)},
      {"tapered_capsule", Capsule(1.0, 0.2, 0.7), test::capsule_oracle(1.0, 0.2, 0.7)},
      {"swallowed_capsule", Capsule(0.5, 1.0, 0.3), test::capsule_oracle(0.5, 1.0, 0.3)},
  };
}

/// Gears of a watch and hills of a planet.
std::vector<ShapeCase> scaled_cases() {
  std::vector<ShapeCase> cases;
  for (const double size : {1e-6, 1e6}) {
    const std::string name = size < 1.0 ? "tiny_" : "huge_";
    const DVec3 half(0.5 * size, size, 0.8 * size);
    cases.push_back({name + "box", Box{half}, test::box_oracle(half), size});
    cases.push_back(
        {name + "disk", Disk{size, 0.3 * size}, test::disk_oracle(size, 0.3 * size), size});
    cases.push_back({name + "cylinder", Cylinder{size, 0.7 * size, 0.4 * size},
                     test::cylinder_oracle(size, 0.7 * size, 0.4 * size), size});
    cases.push_back({name + "capsule", Capsule(size, 0.5 * size, 0.3 * size),
                     test::capsule_oracle(size, 0.5 * size, 0.3 * size), size});
    cases.push_back(quadric_case(name + "quadric",
                                 quadric_matrix(QuadricForm::hyperboloid_one_sheet, half, 0.5),
                                 half, true, 2.0 / size));
  }
  return cases;
}

std::vector<ShapeCase> quadric_cases() {
  std::vector<ShapeCase> cases;
  const DVec3 axes(1.0, 0.5, 0.75);
  const auto form = [&](QuadricForm which) { return quadric_matrix(which, axes, 0.5); };
  const DVec3 half_box = axes * DVec3(1.0, 0.6, 1.0);
  cases.push_back(quadric_case("ellipsoid", form(QuadricForm::ellipsoid), axes * 1.01, false));
  cases.push_back(quadric_case("cut_ellipsoid", form(QuadricForm::ellipsoid), half_box, true));
  cases.push_back(quadric_case("open_cylinder", form(QuadricForm::cylinder), axes, false));
  cases.push_back(quadric_case("open_cone", form(QuadricForm::cone), axes, false));
  cases.push_back(quadric_case("paraboloid", form(QuadricForm::paraboloid), axes, false));
  cases.push_back(quadric_case("capped_paraboloid", form(QuadricForm::paraboloid), axes, true));
  cases.push_back(quadric_case("one_sheet", form(QuadricForm::hyperboloid_one_sheet), axes, false));
  cases.push_back(
      quadric_case("capped_one_sheet", form(QuadricForm::hyperboloid_one_sheet), axes, true));
  cases.push_back(
      quadric_case("two_sheets", form(QuadricForm::hyperboloid_two_sheets), axes, false));
  cases.push_back(
      quadric_case("capped_two_sheets", form(QuadricForm::hyperboloid_two_sheets), axes, true));
  // The saddle y = x^2 - z^2, turned; two planes, x^2 = z^2; one plane, 2x - y + 0.2 = 0; and what
  // is around an ellipsoid.
  cases.push_back(quadric_case(
      "general", symmetric({1, 0.3, 0.2, 0.1, -0.2, 0.4, -0.5, -1, 0, 0.05}), DVec3(1.0), true));
  cases.push_back(
      quadric_case("two_planes", symmetric({1, 0, 0, 0, 0, 0, 0, -1, 0, 0}), DVec3(1.0), false));
  cases.back().has_coordinates = false;  // the planes contain the axis around which u turns,
  cases.back().ray_kinds = 4;            // and rays that touch them lie in them
  cases.push_back(
      quadric_case("linear", symmetric({0, 0, 0, 1, 0, 0, -0.5, 0, 0, 0.2}), DVec3(1.0), true));
  cases.push_back(
      quadric_case("box_with_hole", -1.0 * form(QuadricForm::ellipsoid), axes * 1.2, true));
  return cases;
}

}  // namespace

std::vector<ShapeCase> closed_form_cases() {
  std::vector<ShapeCase> cases = plain_cases();
  for (const auto& more : {scaled_cases(), quadric_cases()}) {
    cases.insert(cases.end(), more.begin(), more.end());
  }
  cases.push_back(polygon_case());
  return cases;
}

}  // namespace lume::geometry
