// SPDX-License-Identifier: Apache-2.0
#include "shading/lights.h"

#include <algorithm>
#include <cmath>

namespace lume::shading {
namespace {

/// 1 / d^2, or the course's f_att, brought to 0 at the range (KHR_lights_punctual, "Range
/// Property").
float distance_attenuation(const PunctualLight& light, float distance) {
  const float ratio = distance / light.range;  // 0 for an infinite range
  const float window = std::clamp(1.0f - ratio * ratio * ratio * ratio, 0.0f, 1.0f);
  if (!light.attenuation) return window / (distance * distance);
  const Vec3& c = *light.attenuation;
  return window * std::min(1.0f, 1.0f / (c.x + distance * (c.y + distance * c.z)));
}

/// Falls from 1 at the inner to 0 at the outer cone as the extension's reference code has it: the
/// square of a linear ramp in the cosine.
float cone_attenuation(const PunctualLight& light, const Vec3& to_light) {
  const float cos_outer = std::cos(light.outer_cone);
  const float cos_inner = std::cos(light.inner_cone);
  const float width = std::max(cos_inner - cos_outer, 1e-3f);
  const float ramp = (dot(light.direction, -to_light) - cos_outer) / width;
  const float clamped = std::clamp(ramp, 0.0f, 1.0f);
  return clamped * clamped;
}

}  // namespace

Incidence illuminate(const PunctualLight& light, const Vec3& point) {
  if (light.kind == PunctualLight::Kind::directional) {
    return {.illuminance = light.intensity, .to_light = -light.direction};
  }
  const Vec3 offset = light.position - point;
  const float distance = length(offset);
  if (!(distance > 0.0f)) return {};
  Incidence result{.to_light = offset / distance, .distance = distance};
  result.illuminance = light.intensity * distance_attenuation(light, distance);
  if (light.kind == PunctualLight::Kind::spot) {
    result.illuminance *= cone_attenuation(light, result.to_light);
  }
  return result;
}

}  // namespace lume::shading
