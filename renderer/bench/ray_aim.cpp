// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/ray_aim.h"

#include "shading/lights.h"

#include <array>
#include <cmath>

namespace lume::renderer {
namespace {

using geometry::Ray;
using geometry::SurfacePoint;

/// Towards a high sun, a low one, and straight up; +y is up in glTF.
const std::array<Vec3, 3> k_above = {normalize(Vec3(0.5f, 1.0f, 0.3f)),
                                     normalize(Vec3(-0.8f, 0.4f, 0.5f)), Vec3(0.0f, 1.0f, 0.0f)};

enum Dimension : std::uint32_t { k_emitter_choice = 16, k_emitter_position };

}  // namespace

RayAim::RayAim(const PreparedScene& prepared)
    : prepared_(prepared),
      lights_(prepared.scene().lights.size() + (prepared.emitters().empty() ? 0 : 1)),
      fixed_(lights_ == 0) {
  if (fixed_) lights_ = k_above.size();
}

std::optional<Ray> RayAim::aim(const SurfacePoint& point, std::size_t choice,
                               const Sampler& sampler) const {
  for (std::size_t i = 0; i < lights_; ++i) {
    if (const auto ray = aim_at(point, (choice + i) % lights_, sampler)) return ray;
  }
  return std::nullopt;
}

std::optional<Ray> RayAim::aim_at(const SurfacePoint& point, std::size_t light,
                                  const Sampler& sampler) const {
  const auto is_above = [&](const Vec3& direction) {
    return (dot(direction, point.geometric_normal) > 0.0f) == point.front_facing;
  };
  if (fixed_) {
    if (!is_above(k_above[light])) return std::nullopt;
    return shadow_ray_along(point, k_above[light]);
  }
  if (light < prepared_.scene().lights.size()) {
    const shading::PunctualLight& lamp = prepared_.scene().lights[light];
    const shading::Incidence incidence = shading::illuminate(lamp, point.position);
    const bool reaches = incidence.illuminance != shading::Color(0.0f);
    if (!reaches || !is_above(incidence.to_light)) return std::nullopt;
    return std::isinf(incidence.distance) ? shadow_ray_along(point, incidence.to_light)
                                          : shadow_ray(point, lamp.position);
  }
  const EmitterSample sample = prepared_.emitters().sample(
      sampler.get_1d(k_emitter_choice), sampler.get_2d(k_emitter_position), point.position);
  if (!(sample.pdf > 0.0f) || !is_above(sample.position - point.position)) return std::nullopt;
  return shadow_ray(point, sample.position);
}

}  // namespace lume::renderer
