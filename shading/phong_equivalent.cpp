// SPDX-License-Identifier: Apache-2.0
#include "shading/phong_equivalent.h"

#include "shading/fresnel.h"
#include "shading/gltf_bsdf.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace lume::shading {

float equivalent_shininess(float alpha) {
  constexpr float k_infinity = std::numeric_limits<float>::infinity();
  const float theta = std::atan(alpha * std::sqrt(std::numbers::sqrt2_v<float> - 1.0f));
  // ln cos(2 theta) = ln(1 - 2 sin^2(theta)) = log1p(...) keeps narrow lobes apart.
  const float sine = std::sin(theta);
  return alpha > 0.0f ? -std::numbers::ln2_v<float> / std::log1p(-2.0f * sine * sine) : k_infinity;
}

Phong equivalent_phong(const MaterialPoint& point) {
  if (point.material->phong) return *point.material->phong;
  const float dielectric = 1.0f - point.metallic;
  const float alpha = point.roughness * point.roughness;
  Phong phong;
  phong.ambient = phong.diffuse = dielectric * (1.0f - point.transmission);
  const Color reflected = GltfBsdf(point, point.normal, false).reflection_color();
  phong.specular = phong.reflection = max_component(reflected);
  if (phong.specular > 0.0f) phong.specular_color = reflected / phong.specular;
  phong.shininess = equivalent_shininess(alpha);
  phong.glossiness = is_mirror(alpha) ? std::numeric_limits<float>::infinity() : phong.shininess;
  phong.transmission = dielectric * point.transmission;
  phong.transmission_color = point.base_color;
  phong.fresnel = true;
  return phong;
}

}  // namespace lume::shading
