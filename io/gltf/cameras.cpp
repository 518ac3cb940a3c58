// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/cameras.h"

#include "io/gltf/phong.h"

#include <fmt/format.h>

#include <cmath>

namespace lume::io::gltf {
namespace {

using geometry::Camera;
using geometry::DMat4;
using geometry::DVec3;
using geometry::Vec3;
using shading::PunctualLight;

constexpr Range k_half_turn{0.0, std::numbers::pi, true, true};
constexpr Range k_quarter_turn{0.0, std::numbers::pi / 2.0 + 1e-6};

float to_float(double value) { return static_cast<float>(value); }

double magnification(const JsonView& orthographic, std::string_view key) {
  const JsonView value = orthographic.require(key);
  const double result = std::abs(value.number());
  if (!(result > 0.0)) {
    value.fail("is 0, expected a magnification");
  }
  return result;
}

/// Lume clips nothing, but planes that contradict each other point to a mistake.
void check_clipping(const JsonView& projection, const Range& near_range) {
  const double near = projection.number_or("znear", 0.0, near_range);
  if (const auto far = projection.find("zfar"); far && !(far->number(k_positive) > near)) {
    far->fail(fmt::format("is {:g}, expected more than znear, {:g}", far->number(), near));
  }
}

Camera read_camera(const JsonView& json) {
  Camera camera;
  camera.name = json.text_or("name", "");
  const JsonView type = json.require("type");
  if (json.has("perspective") && json.has("orthographic")) {
    json.fail("has both 'perspective' and 'orthographic', expected the one that its type names");
  }
  if (type.text() == "perspective") {
    const JsonView perspective = json.require("perspective");
    check_clipping(perspective, k_positive);
    camera.vertical_fov = to_float(perspective.require("yfov").number(k_half_turn));
    camera.aspect = to_float(perspective.number_or("aspectRatio", 0.0, k_not_negative));
  } else if (type.text() == "orthographic") {
    const JsonView orthographic = json.require("orthographic");
    check_clipping(orthographic, k_not_negative);
    const double x = magnification(orthographic, "xmag");
    const double y = magnification(orthographic, "ymag");
    camera.projection = Camera::Projection::orthographic;
    camera.half_height = to_float(y);
    camera.aspect = to_float(x / y);
  } else {
    type.fail("expected perspective or orthographic");
  }
  return camera;
}

void read_cones(const JsonView& json, PunctualLight& light) {
  const JsonView spot = json.require("spot");
  const double inner = spot.number_or("innerConeAngle", 0.0, k_quarter_turn);
  const double outer = spot.number_or("outerConeAngle", std::numbers::pi / 4.0, k_quarter_turn);
  if (!(inner < outer)) {
    spot.fail(fmt::format("innerConeAngle is {:g}, expected less than outerConeAngle, {:g}", inner,
                          outer));
  }
  light.inner_cone = to_float(inner);
  light.outer_cone = to_float(outer);
}

PunctualLight read_light(const JsonView& json) {
  PunctualLight light;
  light.name = json.text_or("name", "");
  const JsonView type = json.require("type");
  if (type.text() == "directional") {
    light.kind = PunctualLight::Kind::directional;
  } else if (type.text() == "spot") {
    light.kind = PunctualLight::Kind::spot;
    read_cones(json, light);
  } else if (type.text() != "point") {
    type.fail("expected directional, point or spot");
  }
  const std::vector<double> color = json.numbers_or("color", {1, 1, 1}, k_not_negative);
  const double intensity = json.number_or("intensity", 1.0, k_not_negative);
  light.intensity = Vec3(DVec3(color[0], color[1], color[2]) * intensity);
  if (!geometry::is_finite(light.intensity)) {
    json.fail("color times intensity is too large for a float");
  }
  light.range =
      to_float(json.number_or("range", std::numeric_limits<double>::infinity(), k_positive));
  return light;
}

bool is_finite(const DVec3& v) { return std::isfinite(dot(v, v)); }

/// The vector's direction; zero if it has none.
DVec3 direction_of(const DVec3& v) {
  const double size = length(v);
  return size > 1e-30 && std::isfinite(size) ? v / size : DVec3(0.0);
}

}  // namespace

std::vector<Camera> read_cameras(const JsonView& root) {
  std::vector<Camera> cameras;
  for (const JsonView& json : root.items("cameras")) {
    cameras.push_back(read_camera(json));
  }
  return cameras;
}

std::vector<PunctualLight> read_lights(const JsonView& root, Notes& notes) {
  std::vector<PunctualLight> lights;
  if (const std::optional<JsonView> extension = root.extension("KHR_lights_punctual")) {
    for (const JsonView& json : extension->items("lights")) {
      lights.push_back(read_light(json));
      read_phong_light(json, fmt::format("light {}", lights.size() - 1), lights.back(), notes);
    }
  }
  return lights;
}

std::optional<Camera> place(Camera camera, const DMat4& world) {
  const DVec3 backward = direction_of(DVec3(world[2]));
  const DVec3 y(world[1]);
  const DVec3 up = direction_of(y - backward * dot(y, backward));
  if (backward == DVec3(0.0) || up == DVec3(0.0) || !is_finite(DVec3(world[3]))) {
    return std::nullopt;
  }
  camera.position = Vec3(world[3]);
  camera.backward = Vec3(backward);
  camera.up = Vec3(up);
  camera.right = Vec3(cross(up, backward));
  return camera;
}

std::optional<PunctualLight> place(PunctualLight light, const DMat4& world) {
  const DVec3 direction = direction_of(-DVec3(world[2]));
  const bool needs_direction = light.kind != PunctualLight::Kind::point;
  if (!is_finite(DVec3(world[3])) || (needs_direction && direction == DVec3(0.0))) {
    return std::nullopt;
  }
  light.position = Vec3(world[3]);
  if (needs_direction) {
    light.direction = Vec3(direction);
  }
  return light;
}

}  // namespace lume::io::gltf
