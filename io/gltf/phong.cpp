// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/phong.h"

#include "io/gltf/unknown_properties.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace lume::io::gltf {
namespace {

using shading::Color;
using shading::Material;
using shading::Phong;
using shading::PunctualLight;

constexpr const char* k_name = "LUME_materials_phong";

constexpr std::array<std::string_view, 13> k_of_material = {"ambientColor",
                                                            "ambientFactor",
                                                            "diffuseColor",
                                                            "diffuseFactor",
                                                            "fresnel",
                                                            "glossiness",
                                                            "ior",
                                                            "reflectionFactor",
                                                            "shininess",
                                                            "specularColor",
                                                            "specularFactor",
                                                            "transmissionColor",
                                                            "transmissionFactor"};
constexpr std::array<std::string_view, 1> k_of_light = {"attenuation"};
constexpr std::array<std::string_view, 2> k_of_scene = {"ambient", "background"};

constexpr Range k_at_least_one{.lower = 1.0};

/// The extension, with a note on what nobody reads; `place` is where it stands.
std::optional<JsonView> find_phong(const JsonView& json, std::string_view place,
                                   std::span<const std::string_view> properties,
                                   const std::string& subject, Notes& notes) {
  std::optional<JsonView> phong = json.extension(k_name);
  if (phong) {
    note_unknown_properties(*phong, fmt::format("'{}' of a {}", k_name, place), properties, subject,
                            notes);
  }
  return phong;
}

/// A value that fits into a float.
float to_float(const JsonView& json, double value) {
  if (value > std::numeric_limits<float>::max()) {
    json.fail(fmt::format("is {:g}, expected a number that a float can hold", value));
  }
  return static_cast<float>(value);
}

float number_or(const JsonView& phong, std::string_view key, float fallback, const Range& range) {
  const std::optional<JsonView> json = phong.find(key);
  return json ? to_float(*json, json->number(range)) : fallback;
}

float factor_or(const JsonView& phong, std::string_view key, float fallback) {
  return number_or(phong, key, fallback, k_unit);
}

geometry::Vec3 read_three(const JsonView& json, const Range& range) {
  const std::vector<double> numbers = json.numbers(3, range);
  const std::vector<JsonView> items = json.items();
  return {to_float(items[0], numbers[0]), to_float(items[1], numbers[1]),
          to_float(items[2], numbers[2])};
}

Color color_or_white(const JsonView& phong, std::string_view key) {
  const std::optional<JsonView> json = phong.find(key);
  return json ? read_three(*json, k_unit) : Color(1.0f);
}

/// The extension's own, else what KHR_materials_ior or its default has put into `material`.
float read_ior(const JsonView& json, const JsonView& phong, const Material& material) {
  if (phong.has("ior") || material.ior >= 1.0f) {
    return number_or(phong, "ior", material.ior, k_at_least_one);
  }
  json.extension("KHR_materials_ior")
      .value_or(json)
      .fail(fmt::format(
          "an \"ior\" of 0 means nothing beside {}: expected at least 1, here or there", k_name));
}

Phong read_coefficients(const JsonView& phong) {
  Phong result;
  result.ambient = factor_or(phong, "ambientFactor", result.ambient);
  result.ambient_color = color_or_white(phong, "ambientColor");
  result.diffuse = factor_or(phong, "diffuseFactor", result.diffuse);
  result.diffuse_color = color_or_white(phong, "diffuseColor");
  result.specular = factor_or(phong, "specularFactor", result.specular);
  result.specular_color = color_or_white(phong, "specularColor");
  result.shininess = number_or(phong, "shininess", result.shininess, k_not_negative);
  result.reflection = factor_or(phong, "reflectionFactor", result.specular);
  result.glossiness = number_or(phong, "glossiness", result.glossiness, k_not_negative);
  result.transmission = factor_or(phong, "transmissionFactor", result.transmission);
  result.transmission_color = color_or_white(phong, "transmissionColor");
  result.fresnel = phong.boolean_or("fresnel", result.fresnel);
  return result;
}

/// What the extension says of a scene.
struct Surroundings {
  Color ambient{0.0f};
  std::optional<Color> background;
};

Surroundings read_surroundings(const JsonView& phong) {
  Surroundings result;
  if (const std::optional<JsonView> ambient = phong.find("ambient")) {
    result.ambient = read_three(*ambient, k_not_negative);
  }
  if (const std::optional<JsonView> background = phong.find("background")) {
    result.background = read_three(*background, k_not_negative);
  }
  return result;
}

}  // namespace

void read_phong_material(const JsonView& json, Material& material, Notes& notes) {
  const std::string subject = "material '" + material.name + "'";
  if (const auto phong = find_phong(json, "material", k_of_material, subject, notes)) {
    material.phong = read_coefficients(*phong);
    material.ior = read_ior(json, *phong, material);
  }
}

void read_phong_light(const JsonView& json, const std::string& subject, PunctualLight& light,
                      Notes& notes) {
  const auto phong = find_phong(json, "light", k_of_light, subject, notes);
  const std::optional<JsonView> attenuation =
      phong ? phong->find("attenuation") : std::optional<JsonView>();
  if (!attenuation) {
    return;
  }
  if (light.kind == PunctualLight::Kind::directional) {
    attenuation->fail("a directional light has no distance: expected a point or spot light");
  }
  light.attenuation = read_three(*attenuation, k_not_negative);
  if (*light.attenuation == geometry::Vec3(0.0f)) {
    attenuation->fail("is 0 in all three, expected one above 0");
  }
}

void read_phong_scenes(const JsonView& root, std::size_t chosen, shading::Scene& scene,
                       Notes& notes) {
  const std::vector<JsonView> scenes = root.items("scenes");
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const std::string subject = fmt::format("scene {}", i);
    const auto phong = find_phong(scenes[i], "scene", k_of_scene, subject, notes);
    if (!phong) {
      continue;
    }
    const Surroundings surroundings = read_surroundings(*phong);
    if (i == chosen) {
      scene.ambient = surroundings.ambient;
      scene.background = surroundings.background;
    }
  }
}

}  // namespace lume::io::gltf
