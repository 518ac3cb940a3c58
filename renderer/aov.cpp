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

constexpr std::array<AovInfo, 7> k_infos = {{
    {Aov::depth, "depth", k_depth, true, "distance along the viewing axis in metres"},
    {Aov::position, "position", k_position, true, "world position in metres"},
    {Aov::normal, "normal", k_normal, false, "shading normal in the world, facing the camera"},
    {Aov::geometric_normal, "geometric_normal", k_geometric_normal, false,
     "normal of the surface itself in the world, on its front side"},
    {Aov::albedo, "albedo", k_albedo, false, "base colour, linear Rec.709"},
    {Aov::instance, "instance", k_instance, true, "number of the instance, from 1; 0 for none"},
    {Aov::material, "material", k_material, true, "number of the material, from 1; 0 for none"},
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
  }
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
  float* next = out.data();
  for (const Aov aov : aovs) {
    if (point) {
      write_aov(aov, prepared, camera, *point, -ray.direction, next);
    } else if (aov == Aov::depth) {
      *next = k_no_depth;
    }
    next += info(aov).channels.size();
  }
}

}  // namespace lume::renderer
