// SPDX-License-Identifier: Apache-2.0
#include "renderer/emitters.h"

#include "shading/material_point.h"

#include <algorithm>
#include <cmath>

namespace lume::renderer {
namespace {

using geometry::Hit;
using geometry::SurfacePoint;

/// Corners of a triangle in the scene's frame.
std::array<Vec3, 3> world_corners(const geometry::World& world, const Hit& hit) {
  auto corners = world.geometry(hit).mesh()->corners(hit.primitive);
  const geometry::Transform& transform = world.transform(hit);
  for (Vec3& corner : corners) {
    corner = Vec3(transform.point_to_world(geometry::DVec3(corner)));
  }
  return corners;
}

/// What the triangle emits, by the mean of an even grid of points. A texture may hide a spark
/// between them, so every triangle keeps a share of what its factor alone would emit.
float mean_luminance(const shading::Scene& scene, const Hit& hit) {
  constexpr int k_grid = 4;
  constexpr float k_least_share = 0.02f;
  SurfacePoint point;
  point.hit = hit;
  point.geometry = &scene.world.geometry(hit);
  const shading::Material& material = scene.materials[point.geometry->material];
  const float whole = shading::luminance(material.emission);
  if (!material.emission_texture) return whole;
  float sum = 0.0f;
  int count = 0;
  for (int i = 0; i < k_grid; ++i) {
    for (int j = 0; i + j < k_grid; ++j, ++count) {
      point.uv = (Vec2(static_cast<float>(i), static_cast<float>(j)) + 1.0f / 3.0f) /
                 static_cast<float>(k_grid);
      sum += shading::luminance(shading::evaluate_emission(scene, point));
    }
  }
  return std::max(sum / static_cast<float>(count), k_least_share * whole);
}

}  // namespace

Emitters::Emitters(const shading::Scene& scene) : scene_(&scene) {
  const geometry::World& world = scene.world;
  std::vector<float> weights;
  first_.resize(world.instances.size());
  Hit hit;
  for (hit.instance = 0; hit.instance < world.instances.size(); ++hit.instance) {
    const auto& geometries = world.objects[world.instances[hit.instance].object].geometries;
    for (hit.geometry = 0; hit.geometry < geometries.size(); ++hit.geometry) {
      const geometry::Mesh* mesh = geometries[hit.geometry].mesh();
      if (mesh == nullptr) continue;
      if (!scene.materials[geometries[hit.geometry].material].is_emissive()) continue;
      first_[hit.instance].resize(geometries.size(), k_none);
      first_[hit.instance][hit.geometry] = static_cast<std::uint32_t>(triangles_.size());
      for (hit.primitive = 0; hit.primitive < mesh->triangles.size(); ++hit.primitive) {
        const auto [a, b, c] = world_corners(world, hit);
        const float area = 0.5f * length(cross(b - a, c - a));
        triangles_.push_back({hit, area});
        weights.push_back(area > 0.0f ? area * mean_luminance(scene, hit) : 0.0f);
      }
    }
  }
  if (!triangles_.empty()) distribution_.emplace(weights);
}

EmitterSample Emitters::sample(float choice, Vec2 random) const {
  const auto chosen = distribution_->sample(choice);
  const Triangle& triangle = triangles_[chosen.cell];
  // Uniform over the triangle (Turk 1990, "Generating Random Points in Triangles", Graphics Gems).
  const float root = std::sqrt(random.x);
  EmitterSample result;
  result.hit = triangle.hit;
  result.uv = {root * (1.0f - random.y), root * random.y};
  const auto [a, b, c] = world_corners(scene_->world, triangle.hit);
  result.position = a + result.uv.x * (b - a) + result.uv.y * (c - a);
  const geometry::World& world = scene_->world;
  const auto corners = world.geometry(triangle.hit).mesh()->corners(triangle.hit.primitive);
  const Vec3 object_normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const geometry::Transform& transform = world.transform(triangle.hit);
  result.normal = normalize(Vec3(transform.normal_to_world(geometry::DVec3(object_normal))));
  result.area_pdf = triangle.area > 0.0f ? chosen.probability / triangle.area : 0.0f;
  return result;
}

float Emitters::area_pdf(const Hit& hit) const {
  if (triangles_.empty() || first_[hit.instance].empty()) return 0.0f;
  const std::uint32_t first = first_[hit.instance][hit.geometry];
  if (first == k_none) return 0.0f;
  const std::uint32_t index = first + hit.primitive;
  const float area = triangles_[index].area;
  return area > 0.0f ? distribution_->probability(index) / area : 0.0f;
}

}  // namespace lume::renderer
