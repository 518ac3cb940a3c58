// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/shape_types.h"

#include "io/gltf/shape_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace lume::io::gltf {
namespace {

using geometry::Shape;

/// Says it of the member, or of the whole where the member is absent and has its default.
[[noreturn]] void fail_at(const JsonView& parameters, std::string_view key,
                          const std::string& reason) {
  parameters.find(key).value_or(parameters).fail(reason);
}

Shape read_sphere(const JsonView& json) {
  return geometry::Sphere{json.number_or("radius", 0.5, k_length)};
}

Shape read_box(const JsonView& json) {
  const std::vector<double> size = json.numbers_or("size", {1, 1, 1}, k_length);
  return geometry::Box{0.5 * geometry::DVec3(size[0], size[1], size[2])};
}

struct Tapered {
  double height;
  double radius_bottom;
  double radius_top;
};

Tapered read_tapered(const JsonView& json) {
  const Tapered result{json.number_or("height", 0.5, k_length),
                       json.number_or("radiusBottom", 0.25, k_length_or_zero),
                       json.number_or("radiusTop", 0.25, k_length_or_zero)};
  if (std::max(result.radius_bottom, result.radius_top) < k_length.lower) {
    json.fail("has no thickness: radiusBottom and radiusTop are both 0, expected one above 0");
  }
  return result;
}

Shape read_cylinder(const JsonView& json) {
  const Tapered tapered = read_tapered(json);
  return geometry::Cylinder{tapered.height, tapered.radius_bottom, tapered.radius_top};
}

Shape read_capsule(const JsonView& json) {
  const Tapered tapered = read_tapered(json);
  return geometry::Capsule(tapered.height, tapered.radius_bottom, tapered.radius_top);
}

Shape read_plane(const JsonView& json) {
  static_cast<void>(json.boolean_or("doubleSided", false));  // the binding's material gets it
  const auto size = [&](std::string_view key) {
    return json.has(key) ? json.require(key).number(k_length)
                         : std::numeric_limits<double>::infinity();
  };
  return geometry::Plane{size("sizeX"), size("sizeZ")};
}

Shape read_disk(const JsonView& json) {
  const geometry::Disk disk{json.number_or("radius", 0.5, k_length),
                            json.number_or("innerRadius", 0.0, k_length_or_zero)};
  if (disk.inner_radius >= disk.radius) {
    fail_at(json, "innerRadius",
            fmt::format("is {:g}, expected less than the radius, {:g}", disk.inner_radius,
                        disk.radius));
  }
  return disk;
}

Shape read_torus(const JsonView& json) {
  const geometry::Torus torus{json.number_or("majorRadius", 0.375, k_length),
                              json.number_or("minorRadius", 0.125, k_length)};
  if (torus.minor_radius > torus.major_radius) {
    fail_at(json, "minorRadius",
            fmt::format("is {:g}, expected at most the majorRadius, {:g}", torus.minor_radius,
                        torus.major_radius));
  }
  return torus;
}

template <std::size_t N>
using Names = std::array<std::string_view, N>;

constexpr Names<1> k_sphere = {"radius"};
constexpr Names<1> k_box = {"size"};
constexpr Names<3> k_tapered = {"height", "radiusBottom", "radiusTop"};
constexpr Names<3> k_plane = {"doubleSided", "sizeX", "sizeZ"};
constexpr Names<2> k_disk = {"innerRadius", "radius"};
constexpr Names<2> k_torus = {"majorRadius", "minorRadius"};
constexpr Names<6> k_quadric = {"caps", "clip", "coefficients", "form", "semiAxes", "waist"};
constexpr Names<2> k_polygon = {"holes", "outline"};
constexpr Names<2> k_implicit = {"bounds", "expression"};
constexpr Names<2> k_bezier = {"patches", "points"};

constexpr auto k_types = std::to_array<ShapeType>({
    {"sphere", k_sphere, false, read_sphere},
    {"box", k_box, false, read_box},
    {"cylinder", k_tapered, false, read_cylinder},
    {"capsule", k_tapered, false, read_capsule},
    {"plane", k_plane, false, read_plane},
    {"LUME_disk", k_disk, false, read_disk},
    {"LUME_torus", k_torus, false, read_torus},
    {"LUME_quadric", k_quadric, true, read_quadric},
    {"LUME_polygon", k_polygon, true, read_polygon},
    {"LUME_implicit", k_implicit, true, read_implicit},
    {"LUME_bezier_patch", k_bezier, true, read_bezier},
});

}  // namespace

geometry::DVec3 read_point(const JsonView& point) {
  const std::vector<double> numbers = point.numbers(3, k_coordinate);
  return {numbers[0], numbers[1], numbers[2]};
}

std::span<const ShapeType> shape_types() { return k_types; }

const ShapeType* find_shape_type(std::string_view name) {
  const auto it = std::find_if(k_types.begin(), k_types.end(),
                               [&](const ShapeType& type) { return type.name == name; });
  return it == k_types.end() ? nullptr : &*it;
}

}  // namespace lume::io::gltf
