// SPDX-License-Identifier: Apache-2.0
// A ray of the tree, and how it is followed through whatever does not cover all that lies behind.
#pragma once

#include "renderer/direct_light.h"
#include "renderer/integrator.h"
#include "renderer/ray_tree.h"
#include "renderer/shadow.h"
#include "shading/material_point.h"

namespace lume::renderer {

/// A ray, and what must be known of the path to it.
struct Branch {
  geometry::Ray ray;  ///< the direction is a unit vector
  RayKind kind = RayKind::camera;
  float travelled = 0.0f;  ///< metres to the ray's origin from the last surface that bent it
  int depth = 0;           ///< reflections and refractions so far
  float weight = 1.0f;     ///< what its light counts for in the pixel
  /// Density of the direction when shadow rays looked for the same light; 0: they did not.
  float pdf = 0.0f;
  EnvironmentAim aim;                         ///< of those shadow rays
  const shading::Material* inside = nullptr;  ///< the solid it runs through
};

/// What the branch sees where it leaves the scene, shared with the shadow rays of the surface that
/// it was reflected by; none where nothing is drawn.
[[nodiscard]] std::optional<Color> backdrop(const PreparedScene& prepared, const Branch& branch);

/// The light that a surface sends along the branch by itself and by what reaches it straight from
/// the lights: all terms but the recursive ones.
[[nodiscard]] Radiance local_light(const PreparedScene& prepared, const Branch& branch,
                                   const ShadedPoint& point, const IntegratorSettings& settings,
                                   const Sampler& sampler, Ledger& ledger, SurfaceNote* note);

/// Follows a branch through alpha-blended layers to the first thing that covers the rest, and adds
/// up what each sends back: shade(branch, point, material, sampler, note), where `note` is null
/// unless a tree is kept.
template <class Shade>
Radiance follow(const PreparedScene& prepared, Branch branch, Sampler sampler, Ledger& ledger,
                const Shade& shade) {
  constexpr int k_most_layers = 1000;
  constexpr std::uint32_t k_next_layer = 10;  // a child of the sampler that no integrator uses
  const std::size_t number = ledger.tree != nullptr ? ledger.tree->rays.size() : 0;
  if (ledger.tree != nullptr) {
    ledger.tree->rays.push_back({branch.kind, branch.depth, branch.ray, {}, {}});
  }
  Radiance result;
  float uncovered = 1.0f;
  Color passes(1.0f);  // what the solid around the ray has not absorbed
  for (int layer = 0; layer < k_most_layers && uncovered > 0.0f; ++layer) {
    const auto point = prepared.first_surface(branch.ray);
    if (!point) {
      const std::optional<Color> seen = backdrop(prepared, branch);
      if (!seen) break;
      const Color share = uncovered * passes * *seen;
      result.terms.emitted += share;
      result.alpha += uncovered;
      if (ledger.tree != nullptr) ledger.tree->rays[number].backdrop = share;
      break;
    }
    if (branch.inside != nullptr) passes *= absorb(*branch.inside, point->t);
    const auto material =
        shading::evaluate_material(prepared.scene(), *point, -branch.ray.direction);
    if (material.coverage > 0.0f) {
      const float share = uncovered * material.coverage;
      const Color scale = share * passes;
      std::optional<SurfaceNote> note;
      if (ledger.tree != nullptr) note.emplace();
      const Radiance sent = shade(branch, *point, material, sampler, note ? &*note : nullptr);
      result.terms += scale * sent.terms;
      result.shadow += scale * sent.shadow;
      result.alpha += share;
      result.depth = std::max(result.depth, sent.depth);
      if (note) {
        note->point = *point;
        note->scale = scale;
        note->terms = sent.terms;
        ledger.tree->rays[number].surfaces.push_back(*note);
      }
    }
    uncovered *= 1.0f - material.coverage;
    branch.ray = leave(*point, branch.ray.direction);
    branch.travelled += point->t;
    sampler = sampler.branch(k_next_layer);
  }
  return result;
}

}  // namespace lume::renderer
