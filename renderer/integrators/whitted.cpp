// SPDX-License-Identifier: Apache-2.0
// Recursive ray tracing (Whitted 1980, "An Improved Illumination Model for Shaded Display"): at
// each surface light that comes straight from the lights, plus what a reflected and a refracted ray
// bring back. On rough surfaces both rays are drawn from the microfacets instead of running along
// the mirror direction (Cook, Porter, Carpenter 1984, "Distributed Ray Tracing"). Light that has
// bounced off a diffuse surface is not found; see docs/whitted.md.
#include "renderer/integrators/whitted.h"

#include "renderer/direct_light.h"
#include "renderer/shadow.h"
#include "shading/bsdf.h"
#include "shading/material_point.h"

namespace lume::renderer {
namespace {

using geometry::SurfacePoint;
using shading::Bsdf;
using shading::MaterialPoint;

/// Dimensions of the sampler beyond those of direct_light, and the numbers of the child rays.
enum Dimension : std::uint32_t { k_reflection = 8, k_transmission, k_next_layer };

/// A ray of the tree, and what it needs to know of the path to it.
struct Branch {
  geometry::Ray ray;       ///< the direction is a unit vector
  float travelled = 0.0f;  ///< metres to the ray's origin from the last surface that bent it
  int depth = 0;           ///< reflections and refractions so far
  float weight = 1.0f;     ///< what its light counts for in the pixel
  /// Density of the direction when shadow rays looked for the same light; 0: they did not.
  float pdf = 0.0f;
  EnvironmentAim aim;                         ///< of those shadow rays
  const shading::Material* inside = nullptr;  ///< the solid it runs through
};

class Whitted final : public Integrator {
 public:
  Whitted(const PreparedScene& prepared, const IntegratorSettings& settings)
      : prepared_(prepared), scene_(prepared.scene()), max_depth_(settings.max_depth) {}

  Radiance radiance(const geometry::Ray& ray, const Sampler& sampler,
                    RayCounts& counts) const override {
    ++counts.camera;
    return trace({.ray = ray, .aim = {}}, sampler, counts);
  }

 private:
  /// Follows a ray through alpha-blended layers to the first thing that covers the rest.
  Radiance trace(Branch branch, Sampler sampler, RayCounts& counts) const {
    constexpr int k_most_layers = 1000;
    Radiance result;
    float uncovered = 1.0f;
    Color passes(1.0f);  // what the solid around the ray has not absorbed
    for (int layer = 0; layer < k_most_layers; ++layer) {
      const auto point = prepared_.first_surface(branch.ray);
      if (!point) {
        add_backdrop(branch, uncovered, passes, result);
        return result;
      }
      if (branch.inside != nullptr) passes *= absorb(*branch.inside, point->t);
      const Vec3 to_viewer = -branch.ray.direction;
      const MaterialPoint material = evaluate_material(scene_, *point, to_viewer);
      if (material.coverage > 0.0f) {
        const float share = uncovered * material.coverage;
        result.color += share * passes * shade(branch, *point, material, sampler, counts);
        result.alpha += share;
      }
      uncovered *= 1.0f - material.coverage;
      if (uncovered <= 0.0f) return result;
      branch.ray = leave(*point, branch.ray.direction);
      branch.travelled += point->t;
      sampler = sampler.branch(k_next_layer);
    }
    return result;
  }

  void add_backdrop(const Branch& branch, float uncovered, const Color& passes,
                    Radiance& result) const {
    const bool is_camera_ray = branch.depth == 0;
    if (!scene_.environment || (is_camera_ray && !scene_.environment->visible)) return;
    const Vec3& direction = branch.ray.direction;
    const float share = branch.pdf > 0.0f
                            ? balance(branch.pdf, environment_pdf(prepared_, branch.aim, direction))
                            : 1.0f;
    result.color += uncovered * share * passes * scene_.environment->radiance(direction);
    result.alpha += uncovered;
  }

  /// Radiance from the surface towards the origin of the branch's ray.
  Color shade(const Branch& branch, const SurfacePoint& point, const MaterialPoint& material,
              const Sampler& sampler, RayCounts& counts) const {
    if (material.material->unlit) return material.base_color;
    const Vec3 to_viewer = -branch.ray.direction;
    const bool inside = material.material->is_solid() && !point.front_facing;
    const Bsdf bsdf(material, to_viewer, inside);
    const bool reflects = is_worth_tracing(branch, bsdf.reflectance_estimate());

    Color color = emission(branch, point);
    color += direct_light(prepared_, {point, material, bsdf, reflects}, sampler, counts);
    if (reflects) {
      if (const auto sample = bsdf.sample_reflection(sampler.get_2d(k_reflection))) {
        ++counts.reflection;
        Branch child = spawn(branch, point, *sample);
        child.ray = leave(point, turned_outwards(sample->direction, point));
        child.aim = environment_aim(material, bsdf);
        color += sample->weight * trace(child, sampler.branch(k_reflection), counts).color;
      }
    }
    if (is_worth_tracing(branch, bsdf.transmission_color())) {
      if (const auto sample = bsdf.sample_transmission(sampler.get_2d(k_transmission))) {
        ++counts.refraction;
        Branch child = spawn(branch, point, *sample);
        if (material.material->is_solid()) child.inside = inside ? nullptr : material.material;
        color += sample->weight * trace(child, sampler.branch(k_transmission), counts).color;
      }
    }
    return color;
  }

  /// Emitted light, shared with the shadow rays of the surface that this branch was reflected by.
  Color emission(const Branch& branch, const SurfacePoint& point) const {
    const Color emitted = shading::evaluate_emission(scene_, point);
    if (branch.pdf <= 0.0f || emitted == Color(0.0f)) return emitted;
    const float distance = branch.travelled + point.t;
    return emitted *
           balance(branch.pdf, emitter_pdf(prepared_, point, distance, branch.ray.direction));
  }

  /// On a mapped normal a reflection can point into the actual surface, where nothing but the
  /// inside of the object would be seen; it is mirrored back out.
  static geometry::Vec3 turned_outwards(const geometry::Vec3& direction,
                                        const SurfacePoint& point) {
    const float side = point.front_facing ? 1.0f : -1.0f;
    const float height = side * dot(direction, point.geometric_normal);
    return height < 0.0f ? direction - 2.0f * height * side * point.geometric_normal : direction;
  }

  /// The ray that goes on from `parent` in a sampled direction, through the same solid.
  static Branch spawn(const Branch& parent, const SurfacePoint& point,
                      const shading::LobeSample& sample) {
    return {.ray = leave(point, sample.direction),
            .depth = parent.depth + 1,
            .weight = parent.weight * shading::max_component(sample.weight),
            .pdf = sample.pdf,
            .aim = {},
            .inside = parent.inside};
  }

  [[nodiscard]] bool is_worth_tracing(const Branch& branch, const Color& weight) const {
    // Light that would be seen at less than a ten-thousandth of its strength is left out.
    constexpr float k_least_weight = 1e-4f;
    return branch.depth < max_depth_ &&
           branch.weight * shading::max_component(weight) > k_least_weight;
  }

  const PreparedScene& prepared_;
  const shading::Scene& scene_;
  int max_depth_;
};

}  // namespace

std::unique_ptr<Integrator> make_whitted(const PreparedScene& prepared,
                                         const IntegratorSettings& settings) {
  return std::make_unique<Whitted>(prepared, settings);
}

}  // namespace lume::renderer
