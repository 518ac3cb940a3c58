// SPDX-License-Identifier: Apache-2.0
#include "lume_version.h"
#include "renderer/cli/trace_report.h"
#include "renderer/cli/trace_terms.h"

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>

namespace lume::cli {
namespace {

using Json = nlohmann::ordered_json;
using geometry::Vec3;
using renderer::LightNote;
using renderer::RayNote;
using renderer::RayTree;
using renderer::SurfaceNote;
using shading::Color;

/// The number that prints as the shortest decimal from which the float can be had back: 0.1, not
/// 0.10000000149011612. It is read as a double first, and where that would round elsewhere the
/// float itself is printed.
double readable(float value) {
  std::array<char, 32> text{};
  const char* end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double result = 0.0;
  std::from_chars(text.data(), end, result);
  return static_cast<float>(result) == value ? result : static_cast<double>(value);
}

/// JSON has no word for what is infinite or NaN, so such a value is left out.
void put(Json& json, const char* key, float value) {
  if (std::isfinite(value)) json[key] = readable(value);
}

void put(Json& json, const char* key, const Vec3& v) {
  if (std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)) {
    json[key] = {readable(v.x), readable(v.y), readable(v.z)};
  }
}

void put_terms(Json& json, const renderer::LightTerms& terms) {
  put(json, "emitted", terms.emitted);
  put(json, "ambient", terms.ambient);
  put(json, "diffuse", terms.diffuse);
  put(json, "specular", terms.specular);
  put(json, "reflected", terms.reflected);
  put(json, "transmitted", terms.transmitted);
}

Json terms_to_json(const renderer::LightTerms& terms) {
  Json json = Json::object();
  put_terms(json, terms);
  return json;
}

Json radiance_to_json(const renderer::Radiance& radiance) {
  Json json = terms_to_json(radiance.terms);
  put(json, "color", radiance.color());
  put(json, "alpha", radiance.alpha);
  return json;
}

void put_ray(Json& json, const geometry::Ray& ray) {
  put(json, "origin", ray.origin);
  put(json, "direction", ray.direction);
  put(json, "t_min", ray.t_min);
  put(json, "t_max", ray.t_max);
}

std::string_view light_kind(LightNote::Kind kind) {
  switch (kind) {
    case LightNote::Kind::environment:
      return "environment";
    case LightNote::Kind::emitter:
      return "emitter";
    case LightNote::Kind::punctual:
      break;
  }
  return "punctual";
}

void put_hit(Json& json, const shading::Scene& scene, const geometry::Hit& hit) {
  json["instance"] = hit.instance;
  json["geometry"] = hit.geometry;
  json["primitive"] = hit.primitive;
  json["object"] = object_name(scene, hit);
}

Json light_to_json(const shading::Scene& scene, const LightNote& light,
                   const SurfaceNote& surface) {
  Json json = {{"kind", light_kind(light.kind)}, {"name", light_name(scene, light)}};
  if (light.kind == LightNote::Kind::punctual) json["index"] = light.index;
  if (light.kind == LightNote::Kind::emitter) put_hit(json["emitter"], scene, light.emitter);
  put_ray(json, light.ray);
  if (const auto position = light_position(light)) put(json, "target", *position);
  put(json, "to_light", direction_to_light(light, surface.point));
  put(json, "light", light.light);
  put(json, "transmittance", light.transmittance);
  put(json, "diffuse", light.diffuse);
  put(json, "specular", light.specular);
  return json;
}

Json coefficients_to_json(const Coefficients& coefficients) {
  Json json = {{"equivalent", coefficients.equivalent}};
  put(json, "ambient", coefficients.ambient());
  put(json, "diffuse", coefficients.diffuse());
  put(json, "specular", coefficients.specular());
  put(json, "shininess", coefficients.phong.shininess);
  put(json, "reflection", coefficients.reflection());
  put(json, "glossiness", coefficients.phong.glossiness);
  put(json, "transmission", coefficients.transmission());
  put(json, "ior", coefficients.point.material->ior);
  json["fresnel"] = coefficients.phong.fresnel;
  return json;
}

void put_twig(Json& json, const char* key, const std::optional<renderer::TwigNote>& twig) {
  if (!twig) return;
  json[key]["ray"] = twig->ray;
  put(json[key], "weight", twig->weight);
}

Json surface_to_json(const shading::Scene& scene, const RayTree& tree, const RayNote& ray,
                     const SurfaceNote& surface) {
  const geometry::SurfacePoint& point = surface.point;
  const Coefficients coefficients = coefficients_at(scene, ray, surface);
  Json json = Json::object();
  put_hit(json, scene, point.hit);
  json["material"] = {{"index", scene.world.geometry(point.hit).material},
                      {"name", material_name(scene, point.hit)}};
  put(json, "t", distance_to(ray, surface));
  put(json, "position", point.position);
  put(json, "geometric_normal", point.geometric_normal);
  put(json, "normal", point.normal);
  put(json, "shading_normal", coefficients.point.normal);
  json["front_facing"] = point.front_facing;
  json["inside"] = surface.inside;
  put(json, "coverage", coefficients.point.coverage);
  json["coefficients"] = coefficients_to_json(coefficients);
  put(json, "scale", surface.scale);
  put(json, "unoccluded", surface.unoccluded);
  json["terms"] = terms_to_json(surface.terms);
  json["lights"] = Json::array();
  for (std::size_t i = 0; i < surface.light_count; ++i) {
    json["lights"].push_back(light_to_json(scene, tree.lights[surface.first_light + i], surface));
  }
  put_twig(json, "reflection", surface.reflection);
  put_twig(json, "transmission", surface.transmission);
  return json;
}

/// For each ray the one that it branched off; the camera's is its own.
std::vector<std::size_t> parents_of(const RayTree& tree) {
  std::vector<std::size_t> parents(tree.rays.size(), 0);
  for (std::size_t i = 0; i < tree.rays.size(); ++i) {
    for (const SurfaceNote& surface : tree.rays[i].surfaces) {
      if (surface.reflection) parents[surface.reflection->ray] = i;
      if (surface.transmission) parents[surface.transmission->ray] = i;
    }
  }
  return parents;
}

Json rays_to_json(const shading::Scene& scene, const RayTree& tree) {
  const std::vector<std::size_t> parents = parents_of(tree);
  Json list = Json::array();
  for (std::size_t i = 0; i < tree.rays.size(); ++i) {
    const RayNote& ray = tree.rays[i];
    Json json = {{"index", i}, {"kind", name_of(ray.kind)}, {"depth", ray.depth}};
    if (i > 0) json["parent"] = parents[i];
    put_ray(json, ray.ray);
    json["surfaces"] = Json::array();
    for (const SurfaceNote& surface : ray.surfaces) {
      json["surfaces"].push_back(surface_to_json(scene, tree, ray, surface));
    }
    if (ray.backdrop) put(json, "backdrop", *ray.backdrop);
    list.push_back(std::move(json));
  }
  return list;
}

Json settings_to_json(const TraceOptions& options) {
  Json json = {{"integrator", options.integrator},
               {"accelerator", options.accelerator},
               {"spp", options.spp},
               {"seed", options.seed},
               {"filter", options.filter},
               {"max_depth", options.max_depth}};
  put(json, "cutoff", options.cutoff);
  json["shadows"] = !options.no_shadows;
  put(json, "occlusion_distance_metres", options.occlusion_distance);
  return json;
}

Json samples_to_json(const TraceReport& report) {
  Json list = Json::array();
  for (std::size_t i = 0; i < report.trace.samples.size(); ++i) {
    list.push_back({{"index", i},
                    {"value", radiance_to_json(report.trace.sums[i])},
                    {"rays", rays_to_json(report.scene, report.trace.samples[i])}});
  }
  return list;
}

}  // namespace

std::string trace_to_json(const TraceReport& report) {
  const renderer::RayCounts& rays = report.trace.rays;
  const geometry::DVec3& origin = report.scene.origin;
  Json json = {{"lume", k_version},
               {"scene", report.options.scene_file},
               {"camera", report.camera},
               {"light", report.light},
               {"width", report.size.width},
               {"height", report.size.height},
               {"pixel", {report.options.pixel->x, report.options.pixel->y}},
               {"settings", settings_to_json(report.options)},
               {"origin", {origin.x, origin.y, origin.z}}};
  put(json, "ambient_light", report.scene.ambient);
  json["value"] = radiance_to_json(report.trace.value);
  json["ray_counts"] = {{"camera", rays.camera},
                        {"shadow", rays.shadow},
                        {"reflection", rays.reflection},
                        {"refraction", rays.refraction}};
  json["samples"] = samples_to_json(report);
  // Names need not be UTF-8, JSON must be.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lume::cli
