// SPDX-License-Identifier: Apache-2.0
#include "io/check/rules.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace lume::io::check {
namespace {

/// Lumens that exporters make of a watt: the luminous efficacy of light of 555 nm.
constexpr double k_lumens_per_watt = 683.0;
/// The sun at noon is some 100,000 lx, the brightest of searchlights some 10^8 cd; a household lamp
/// has 100 cd.
constexpr double k_brightest_lamp = 5000.0;
constexpr double k_brightest_sun = 130000.0;

/// A whole number of watts (up to what a film set uses) in the guise of candela: W 683 / (4 pi), as
/// exporters write it. 0 if it is none.
double watts_behind(double candela) {
  const double watts = candela * (4.0 * std::numbers::pi) / k_lumens_per_watt;
  const double whole = std::round(watts);
  return whole >= 1.0 && std::abs(watts - whole) < 1e-4 * whole ? whole : 0.0;
}

void check_intensity(const gltf::JsonView& light, Findings& findings) {
  const double intensity = light.number_or("intensity", 1.0, gltf::k_not_negative);
  const std::string pointer = light.pointer() + "/intensity";
  if (light.require("type").text() == "directional") {
    if (intensity > k_brightest_sun) {
      findings.add(Severity::warning, "light-units", pointer,
                   fmt::format("{:g} lx is more than the sun's {:g}", intensity, k_brightest_sun),
                   "divide by 683 if these are watts per square metre in the guise of lux, or "
                   "render with --exposure");
    }
    return;
  }
  const double watts = watts_behind(intensity);
  if (watts >= 10.0) {
    findings.add(Severity::warning, "light-units", pointer,
                 fmt::format("{:.6g} cd is {:g} W times 683 / 4 pi: watts in the guise of candela",
                             intensity, watts),
                 "export with physical units off or divide by 683 if the picture is too bright; "
                 "--exposure scales the whole picture");
  } else if (intensity > k_brightest_lamp) {
    findings.add(Severity::warning, "light-units", pointer,
                 fmt::format("{:g} cd is {:.2g} times a 100 W bulb", intensity, intensity / 130.0),
                 "check the units: glTF has candela, of which a household lamp has about 100");
  }
}

}  // namespace

void check_lights(const Subject& subject, Findings& findings) {
  const gltf::JsonView root = subject.document.root();
  if (const auto extension = root.extension("KHR_lights_punctual")) {
    for (const gltf::JsonView& light : extension->items("lights")) {
      check_intensity(light, findings);
    }
  }
  const shading::Scene& scene = subject.loaded.scene;
  if (scene.cameras.empty()) return;  // a thing to put into a scene, not a scene
  bool is_lit = !scene.lights.empty() || scene.environment || scene.ambient != shading::Color(0.0f);
  for (const shading::Material& material : scene.materials) {
    is_lit = is_lit || material.is_emissive() || material.unlit;
  }
  if (!is_lit) {
    findings.add(Severity::advice, "no-light", "",
                 "the scene has a camera, but no light and nothing that glows",
                 "Lume lights it from a studio around it unless --env names an environment");
  }
}

}  // namespace lume::io::check
