// SPDX-License-Identifier: Apache-2.0
#include "renderer/aov.h"

#include "shading/material_point.h"

#include <algorithm>
#include <array>

namespace lume::renderer {
namespace {

using Names = std::array<std::string_view, 3>;
constexpr std::array<std::string_view, 1> k_depth = {"Z"};
constexpr Names k_position = {"P.x", "P.y", "P.z"};
constexpr Names k_normal = {"N.x", "N.y", "N.z"};
constexpr Names k_geometric_normal = {"Ng.x", "Ng.y", "Ng.z"};
constexpr Names k_albedo = {"albedo.R", "albedo.G", "albedo.B"};
constexpr std::array<std::string_view, 1> k_instance = {"instance.id"};
constexpr std::array<std::string_view, 1> k_material = {"material.id"};

constexpr Names k_emitted = {"emitted.R", "emitted.G", "emitted.B"};
constexpr Names k_ambient = {"ambient.R", "ambient.G", "ambient.B"};
constexpr Names k_diffuse = {"diffuse.R", "diffuse.G", "diffuse.B"};
constexpr Names k_specular = {"specular.R", "specular.G", "specular.B"};
constexpr Names k_reflected = {"reflected.R", "reflected.G", "reflected.B"};
constexpr Names k_transmitted = {"transmitted.R", "transmitted.G", "transmitted.B"};
constexpr Names k_shadow = {"shadow.R", "shadow.G", "shadow.B"};
constexpr std::array<std::string_view, 1> k_recursion_depth = {"recursion_depth.V"};
constexpr std::array<std::string_view, 1> k_ray_count = {"ray_count.V"};
constexpr std::array<std::string_view, 1> k_nodes = {"nodes.V"};
constexpr std::array<std::string_view, 1> k_primitive_tests = {"primitive_tests.V"};

constexpr std::array<AovInfo, 18> k_infos = {{
    {Aov::depth, "depth", k_depth, AovSource::center, "distance along the viewing axis in metres"},
    {Aov::position, "position", k_position, AovSource::center, "world position in metres"},
    {Aov::normal, "normal", k_normal, AovSource::surface,
     "shading normal in the world, facing the camera"},
    {Aov::geometric_normal, "geometric_normal", k_geometric_normal, AovSource::surface,
     "normal of the surface itself in the world, on its front side"},
    {Aov::albedo, "albedo", k_albedo, AovSource::surface, "base colour, linear Rec.709"},
    {Aov::instance, "instance", k_instance, AovSource::center,
     "number of the instance, from 1; 0 for none"},
    {Aov::material, "material", k_material, AovSource::center,
     "number of the material, from 1; 0 for none"},
    {Aov::emitted, "emitted", k_emitted, AovSource::light,
     "light that the surface or the backdrop gives off itself; this and the next five add up to "
     "the "
     "picture"},
    {Aov::ambient, "ambient", k_ambient, AovSource::light, "ambient light that it sends back"},
    {Aov::diffuse, "diffuse", k_diffuse, AovSource::light, "light of the lights, diffusely"},
    {Aov::specular, "specular", k_specular, AovSource::light, "highlights of the lights"},
    {Aov::reflected, "reflected", k_reflected, AovSource::light,
     "what the reflected rays bring back"},
    {Aov::transmitted, "transmitted", k_transmitted, AovSource::light,
     "what the refracted rays bring back"},
    {Aov::shadow, "shadow", k_shadow, AovSource::light,
     "what diffuse and specular would be more if nothing cast a shadow"},
    {Aov::recursion_depth, "recursion_depth", k_recursion_depth, AovSource::light,
     "the most reflections and refractions in a row, mean of the samples"},
    {Aov::ray_count, "ray_count", k_ray_count, AovSource::light,
     "rays of all kinds a sample, mean of the samples"},
    {Aov::nodes, "nodes", k_nodes, AovSource::surface,
     "nodes that the accelerator entered for the camera ray, mean of the samples"},
    {Aov::primitive_tests, "primitive_tests", k_primitive_tests, AovSource::surface,
     "primitives that it tested for the camera ray, mean of the samples"},
}};

const AovInfo& info(Aov aov) { return k_infos[static_cast<std::size_t>(aov)]; }

void write(const Vec3& value, float* out) {
  for (int i = 0; i < 3; ++i) out[i] = value[i];
}

void write_aov(Aov aov, const PreparedScene& prepared, const geometry::Camera& camera,
               const geometry::SurfacePoint& point, const Vec3& to_viewer, float* out) {
  const shading::Scene& scene = prepared.scene();
  switch (aov) {
    case Aov::depth:
      *out = camera.depth(point.position);
      break;
    case Aov::position:
      write(Vec3(scene.origin + geometry::DVec3(point.position)), out);
      break;
    case Aov::normal:
      write(shading::evaluate_material(scene, point, to_viewer).normal, out);
      break;
    case Aov::geometric_normal:
      write(point.geometric_normal, out);
      break;
    case Aov::albedo:
      write(Vec3(shading::evaluate_base_color(scene, point)), out);
      break;
    case Aov::instance:
      *out = static_cast<float>(point.hit.instance + 1);
      break;
    case Aov::material:
      *out = static_cast<float>(point.geometry->material + 1);
      break;
    default:
      break;  // of the light or the cost
  }
}

void write_light_aov(Aov aov, const PixelLight& light, float* out) {
  const LightTerms& terms = light.mean.terms;
  switch (aov) {
    case Aov::emitted:
      return write(terms.emitted, out);
    case Aov::ambient:
      return write(terms.ambient, out);
    case Aov::diffuse:
      return write(terms.diffuse, out);
    case Aov::specular:
      return write(terms.specular, out);
    case Aov::reflected:
      return write(terms.reflected, out);
    case Aov::transmitted:
      return write(terms.transmitted, out);
    case Aov::shadow:
      return write(light.mean.shadow, out);
    case Aov::recursion_depth:
      *out = light.recursion_depth;
      break;
    case Aov::ray_count:
      *out = light.ray_count;
      break;
    default:
      break;  // of the surface
  }
}

/// What the first query for the ray costs, if it is asked for.
geometry::TraversalCost cost_of(std::span<const Aov> aovs, const PreparedScene& prepared,
                                const geometry::Ray& ray) {
  geometry::TraversalCost cost;
  if (std::any_of(aovs.begin(), aovs.end(), is_of_cost)) {
    (void)prepared.accelerator().closest_hit_counted(ray, cost);
  }
  return cost;
}

}  // namespace

std::span<const AovInfo> aov_infos() { return k_infos; }

std::size_t channel_count(std::span<const Aov> aovs) {
  std::size_t count = 0;
  for (const Aov aov : aovs) count += info(aov).channels.size();
  return count;
}

void evaluate_aovs(std::span<const Aov> aovs, const PreparedScene& prepared,
                   const geometry::Camera& camera, const geometry::Ray& ray, std::span<float> out) {
  std::fill(out.begin(), out.end(), 0.0f);
  const auto point = prepared.first_surface(ray);
  const geometry::TraversalCost cost = cost_of(aovs, prepared, ray);
  float* next = out.data();
  for (const Aov aov : aovs) {
    if (is_of_cost(aov)) {
      *next = static_cast<float>(aov == Aov::nodes ? cost.nodes : cost.primitive_tests);
    } else if (point) {
      write_aov(aov, prepared, camera, *point, -ray.direction, next);
    } else if (aov == Aov::depth) {
      *next = k_no_depth;
    }
    next += info(aov).channels.size();
  }
}

void evaluate_light_aovs(std::span<const Aov> aovs, const PixelLight& light, std::span<float> out) {
  float* next = out.data();
  for (const Aov aov : aovs) {
    write_light_aov(aov, light, next);
    next += info(aov).channels.size();
  }
}

}  // namespace lume::renderer
