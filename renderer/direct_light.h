// SPDX-License-Identifier: Apache-2.0
// Light that reaches a surface from the lights themselves, by shadow rays.
#pragma once

#include "renderer/ledger.h"
#include "renderer/prepared_scene.h"
#include "renderer/radiance.h"
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

  /// Whether a direction points out of the actual surface, on the side the viewer is on. A normal
  /// map must not let light in from behind.
  [[nodiscard]] bool is_above(const Vec3& direction) const {
    const float side = surface.front_facing ? 1.0f : -1.0f;
    return side * dot(surface.geometric_normal, direction) > 0.0f;
  }
};

/// Radiance towards the viewer (nits).
struct DirectLight {
  Color diffuse{0.0f};
  Color specular{0.0f};
  Color shadow{0.0f};  ///< what is missing from both because something stands before a light
};

/// Every punctual light in full, one direction of the environment and one point of the emissive
/// surfaces for each call. Uses dimensions 0 to 2 of the sampler. Without `shadows` all lights
/// arrive.
[[nodiscard]] DirectLight direct_light(const PreparedScene& prepared, const ShadedPoint& point,
                                       bool shadows, const Sampler& sampler, Ledger& ledger);

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

/// The balance heuristic's share of the strategy with density `pdf`. A density of 0 stands for a
/// mirror's infinite one, which takes all.
[[nodiscard]] inline float balance(float pdf, float other_pdf) {
  return pdf > 0.0f ? pdf / (pdf + other_pdf) : 1.0f;
}

}  // namespace lume::renderer
