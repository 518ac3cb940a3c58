// SPDX-License-Identifier: Apache-2.0
// Light that reaches a surface from the lights themselves, by shadow rays.
#pragma once

#include "renderer/prepared_scene.h"
#include "renderer/ray_counts.h"
#include "renderer/sampler.h"
#include "shading/bsdf.h"

namespace lume::renderer {

/// A surface that is being shaded.
struct ShadedPoint {
  const geometry::SurfacePoint& surface;
  const shading::MaterialPoint& material;
  const shading::Bsdf& bsdf;
  /// A reflection ray is traced as well. What it can see by itself, the environment and emissive
  /// surfaces, is then shared out between it and the shadow ray by the balance heuristic (Veach and
  /// Guibas 1995, "Optimally Combining Sampling Techniques").
  bool reflects;
};

/// Radiance (nits) towards the viewer: every punctual light in full, one direction of the
/// environment and one point of the emissive surfaces for each call. Uses dimensions 0 to 2 of the
/// sampler.
[[nodiscard]] shading::Color direct_light(const PreparedScene& prepared, const ShadedPoint& point,
                                          const Sampler& sampler, RayCounts& counts);

/// How shadow rays are aimed at the environment: in proportion to its radiance, and for a share of
/// the samples by the cosine instead, which is better where the environment is nearly even.
struct EnvironmentAim {
  Vec3 normal{0.0f};          ///< shading normal, unit
  float cosine_share = 0.0f;  ///< of the samples; 0 for surfaces without a diffuse part
};

[[nodiscard]] EnvironmentAim environment_aim(const shading::MaterialPoint& material,
                                             const shading::Bsdf& bsdf);

/// The density, per steradian, with which direct_light aims a shadow ray into the unit `direction`
/// of the scene's environment.
[[nodiscard]] float environment_pdf(const PreparedScene& prepared, const EnvironmentAim& aim,
                                    const Vec3& direction);

/// The same for the point of an emissive surface that is met along the unit `direction` at a
/// distance (metres) from the surface being shaded.
[[nodiscard]] float emitter_pdf(const PreparedScene& prepared, const geometry::SurfacePoint& met,
                                float distance, const Vec3& direction);

/// The balance heuristic's share of the strategy with density `pdf`. A density of 0 stands for a
/// mirror's infinite one, which takes all.
[[nodiscard]] inline float balance(float pdf, float other_pdf) {
  return pdf > 0.0f ? pdf / (pdf + other_pdf) : 1.0f;
}

}  // namespace lume::renderer
