// SPDX-License-Identifier: Apache-2.0
// A ray of the tree, and how it is followed through whatever does not cover all that lies behind.
#pragma once

#include "renderer/direct_light.h"
#include "renderer/integrator.h"
#include "renderer/ray_tree.h"
#include "renderer/shadow.h"
#include "shading/material_point.h"

#include <algorithm>
#include <optional>

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
/// the lights: all terms but the recursive ones. `result` is black before; it is filled where it
/// is, as copies would cost more than some of the terms.
void local_light(const PreparedScene& prepared, const Branch& branch, const ShadedPoint& point,
                 const IntegratorSettings& settings, const Sampler& sampler, Ledger& ledger,
                 SurfaceNote* note, Radiance& result);

/// Adds what shade() says of a surface, times `scale`, to `result`, and to the tree's `ray` if a
/// tree is kept. `alone`: nothing is in `result` yet, and the scale is 1.
template <class Shade>
void add_surface(const Branch& branch, const geometry::SurfacePoint& point,
                 const shading::MaterialPoint& material, const Color& scale, bool alone,
                 const Sampler& sampler, RayTree* tree, std::size_t ray, const Shade& shade,
                 Radiance& result) {
  std::optional<SurfaceNote> note;
  if (tree != nullptr) note.emplace();
  Radiance scaled;
  Radiance& sent = alone ? result : scaled;
  shade(branch, point, material, sampler, note ? &*note : nullptr, sent);
  if (note) {
    note->point = point;
    note->scale = scale;
    note->terms = sent.terms;
    tree->rays[ray].surfaces.push_back(*note);
  }
  if (alone) return;
  result.terms += scale * sent.terms;
  result.shadow += scale * sent.shadow;
  result.depth = std::max(result.depth, sent.depth);
}

/// Follows a branch through alpha-blended layers to the first thing that covers the rest, and adds
/// up what each sends back: shade(branch, point, material, sampler, note, result), where `note` is
/// null unless a tree is kept, and `result` as for local_light.
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
  for (int layer = 0; layer < k_most_layers; ++layer) {
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
      const bool alone = layer == 0 && scale == Color(1.0f);  // nearly always
      add_surface(branch, *point, material, scale, alone, sampler, ledger.tree, number, shade,
                  result);
      result.alpha += share;
    }
    uncovered *= 1.0f - material.coverage;
    if (!(uncovered > 0.0f)) break;
    branch.ray = leave(*point, branch.ray.direction);
    branch.travelled += point->t;
    sampler = sampler.branch(k_next_layer);
  }
  return result;
}

}  // namespace lume::renderer
