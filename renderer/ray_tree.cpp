// SPDX-License-Identifier: Apache-2.0
#include "renderer/ray_tree.h"

namespace lume::renderer {
namespace {

Color light_of(const RayTree& tree, const std::optional<TwigNote>& twig) {
  return twig ? twig->weight * resum(tree, twig->ray).sum() : Color(0.0f);
}

LightTerms resum(const RayTree& tree, const SurfaceNote& surface) {
  LightTerms terms;
  terms.emitted = surface.terms.emitted;
  terms.ambient = surface.terms.ambient;
  for (std::size_t i = 0; i < surface.light_count; ++i) {
    const LightNote& light = tree.lights[surface.first_light + i];
    terms.diffuse += light.diffuse;
    terms.specular += light.specular;
  }
  terms.reflected = light_of(tree, surface.reflection);
  terms.transmitted = light_of(tree, surface.transmission);
  return terms;
}

}  // namespace

LightTerms resum(const RayTree& tree, std::size_t ray) {
  LightTerms terms;
  for (const SurfaceNote& surface : tree.rays[ray].surfaces) {
    terms += surface.scale * resum(tree, surface);
  }
  if (tree.rays[ray].backdrop) terms.emitted += *tree.rays[ray].backdrop;
  return terms;
}

}  // namespace lume::renderer
