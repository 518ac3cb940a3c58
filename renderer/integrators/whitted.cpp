// SPDX-License-Identifier: Apache-2.0
// Recursive ray tracing (Whitted 1980, "An Improved Illumination Model for Shaded Display"):
//   I = emitted + L_a k_a O_a + sum over lights f_att L_p (k_d O_d (n.l) + k_s O_s (r.v)^n)
//     + k_r O_s I_reflected + k_t O_t I_transmitted.
// On rough surfaces both rays are drawn from the microfacets instead of running along the mirror
// direction (Cook, Porter, Carpenter 1984, "Distributed Ray Tracing"). Light that has bounced off a
// diffuse surface is not found; see docs/whitted.md.
#include "renderer/integrators/whitted.h"

#include "renderer/branch.h"

namespace lume::renderer {
namespace {

using geometry::SurfacePoint;
using geometry::Vec3;
using shading::Bsdf;
using shading::LobeSample;
using shading::MaterialPoint;

/// Dimensions of the sampler beyond those of local_light, and the numbers of the child rays.
enum Dimension : std::uint32_t { k_reflection = 8, k_transmission };

class Whitted final : public Integrator {
 public:
  Whitted(const PreparedScene& prepared, const IntegratorSettings& settings)
      : prepared_(prepared), settings_(settings) {}

  Radiance radiance(const geometry::Ray& ray, const Sampler& sampler,
                    Ledger& ledger) const override {
    ++ledger.counts.camera;
    return trace({.ray = ray, .aim = {}}, sampler, ledger);
  }

 private:
  Radiance trace(const Branch& branch, const Sampler& sampler, Ledger& ledger) const {
    return follow(prepared_, branch, sampler, ledger,
                  [&](const Branch& layer, const SurfacePoint& point, const MaterialPoint& material,
                      const Sampler& layer_sampler, SurfaceNote* note, Radiance& result) {
                    shade(layer, point, material, layer_sampler, ledger, note, result);
                  });
  }

  /// What the surface sends along the branch.
  void shade(const Branch& branch, const SurfacePoint& point, const MaterialPoint& material,
             const Sampler& sampler, Ledger& ledger, SurfaceNote* note, Radiance& result) const {
    const bool solid = material.material->is_solid();
    const bool inside = solid && !point.front_facing;
    const Bsdf bsdf(material, -branch.ray.direction, inside);
    const bool reflects = is_worth_tracing(branch, material, bsdf.reflection_color());
    local_light(prepared_, branch, {point, material, bsdf, reflects}, settings_, sampler, ledger,
                note, result);
    if (note != nullptr) note->inside = inside;
    if (reflects) {
      const Vec2 random = bsdf.reflects_sharply() ? Vec2(0.0f) : sampler.get_2d(k_reflection);
      if (const auto sample = bsdf.sample_reflection(random)) {
        ++ledger.counts.reflection;
        const Vec3 direction = turned_outwards(sample->direction, point);
        Branch child = spawn(branch, RayKind::reflection, leave(point, direction), *sample);
        child.aim = environment_aim(material, bsdf);
        result.terms.reflected = collect(child, *sample, sampler.branch(k_reflection), ledger,
                                         result.depth, note ? &note->reflection : nullptr);
      }
    }
    if (is_worth_tracing(branch, material, bsdf.transmission_color())) {
      const Vec2 random = bsdf.transmits_sharply() ? Vec2(0.0f) : sampler.get_2d(k_transmission);
      if (const auto sample = bsdf.sample_transmission(random)) {
        ++ledger.counts.refraction;
        const geometry::Ray ray = leave(point, sample->direction);
        Branch child = spawn(branch, RayKind::refraction, ray, *sample);
        if (solid) child.inside = inside ? nullptr : material.material;
        result.terms.transmitted = collect(child, *sample, sampler.branch(k_transmission), ledger,
                                           result.depth, note ? &note->transmission : nullptr);
      }
    }
  }

  /// The light of a child ray, weighted. `depth` grows to what was reached.
  Color collect(const Branch& child, const LobeSample& sample, const Sampler& sampler,
                Ledger& ledger, int& depth, std::optional<TwigNote>* note) const {
    if (note != nullptr) *note = {ledger.tree->rays.size(), sample.weight};
    const Radiance light = trace(child, sampler, ledger);
    depth = std::max(depth, light.depth + 1);
    return sample.weight * light.color();
  }

  /// On a mapped normal a reflection can point into the actual surface, where nothing but the
  /// inside of the object would be seen; it is mirrored back out.
  static Vec3 turned_outwards(const Vec3& direction, const SurfacePoint& point) {
    const float side = point.front_facing ? 1.0f : -1.0f;
    const float height = side * dot(direction, point.geometric_normal);
    return height < 0.0f ? direction - 2.0f * height * side * point.geometric_normal : direction;
  }

  /// The ray that goes on from `parent`, through the same solid.
  static Branch spawn(const Branch& parent, RayKind kind, const geometry::Ray& ray,
                      const LobeSample& sample) {
    return {.ray = ray,
            .kind = kind,
            .depth = parent.depth + 1,
            .weight = parent.weight * shading::max_component(sample.weight),
            .pdf = sample.pdf,
            .aim = {},
            .inside = parent.inside};
  }

  [[nodiscard]] bool is_worth_tracing(const Branch& branch, const MaterialPoint& material,
                                      const Color& weight) const {
    return branch.depth < settings_.max_depth && !material.material->unlit &&
           branch.weight * shading::max_component(weight) > settings_.cutoff;
  }

  const PreparedScene& prepared_;
  IntegratorSettings settings_;
};

}  // namespace

std::unique_ptr<Integrator> make_whitted(const PreparedScene& prepared,
                                         const IntegratorSettings& settings) {
  return std::make_unique<Whitted>(prepared, settings);
}

}  // namespace lume::renderer
