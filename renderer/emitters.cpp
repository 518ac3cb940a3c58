// SPDX-License-Identifier: Apache-2.0
#include "renderer/emitters.h"

#include "renderer/emitter_shapes.h"
#include "shading/material_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lume::renderer {
namespace {

using geometry::DVec3;
using geometry::Hit;
using geometry::SurfacePoint;

/// Calls visit(hit, geometry) for the first primitive of every emissive surface of every instance.
template <class Visit>
void for_each_emissive(const shading::Scene& scene, const Visit& visit) {
  const geometry::World& world = scene.world;
  Hit hit;
  for (hit.instance = 0; hit.instance < world.instances.size(); ++hit.instance) {
    const auto& geometries = world.objects[world.instances[hit.instance].object].geometries;
    for (hit.geometry = 0; hit.geometry < geometries.size(); ++hit.geometry) {
      const geometry::Geometry& geometry = geometries[hit.geometry];
      if (scene.materials[geometry.material].is_emissive()) visit(hit, geometry);
    }
  }
}

bool can_be_aimed_at(const geometry::Geometry& geometry) {
  return geometry.mesh() != nullptr || is_area_light(*geometry.shape());
}

/// Two edges of a triangle in its object's space.
struct Edges {
  DVec3 origin, u, v;
};

Edges edges_of(const geometry::Mesh& mesh, std::uint32_t triangle) {
  const auto corners = mesh.corners(triangle);
  const DVec3 origin(corners[0]);
  return {origin, DVec3(corners[1]) - origin, DVec3(corners[2]) - origin};
}

float area_of(const shading::Scene& scene, const Hit& hit) {
  const geometry::Transform& transform = scene.world.transform(hit);
  const geometry::Geometry& geometry = scene.world.geometry(hit);
  if (geometry.mesh() == nullptr) {
    return static_cast<float>(world_area(*geometry.shape(), transform));
  }
  const Edges edges = edges_of(*geometry.mesh(), hit.primitive);
  return static_cast<float>(
      0.5 * length(cross(transform.vector_to_world(edges.u), transform.vector_to_world(edges.v))));
}

/// What the surface emits, by the mean of an even grid of points. A texture may hide a spark
/// between them, so every emitter keeps a share of what its factor alone would emit.
float mean_luminance(const shading::Scene& scene, const Hit& hit) {
  constexpr int k_triangle_grid = 4;
  constexpr int k_shape_grid = 16;
  constexpr float k_least_share = 0.02f;
  SurfacePoint point;
  point.hit = hit;
  point.geometry = &scene.world.geometry(hit);
  const shading::Material& material = scene.materials[point.geometry->material];
  const float whole = shading::luminance(material.emission);
  if (!material.emission_texture) return whole;
  const bool triangle = point.geometry->mesh() != nullptr;
  const int grid = triangle ? k_triangle_grid : k_shape_grid;
  float sum = 0.0f;
  int count = 0;
  for (int i = 0; i < grid; ++i) {
    for (int j = 0; j < (triangle ? grid - i : grid); ++j, ++count) {
      const Vec2 cell(static_cast<float>(i), static_cast<float>(j));
      const Vec2 middle = (cell + (triangle ? 1.0f / 3.0f : 0.5f)) / static_cast<float>(grid);
      point.uv = triangle ? middle : Vec2(uniform_point(*point.geometry->shape(), middle).uv);
      sum += shading::luminance(shading::evaluate_emission(scene, point));
    }
  }
  return std::max(sum / static_cast<float>(count), k_least_share * whole);
}

/// How many m^2 of the surface at `position` fill a steradian as seen from `from`: d^2 / cos. 0 for
/// a surface seen edge on.
double steradian_to_area(const DVec3& position, const DVec3& normal, const DVec3& from) {
  const DVec3 offset = position - from;
  const double distance2 = dot(offset, offset);
  const double cosine = std::abs(dot(normal, offset)) / std::sqrt(distance2);
  return cosine > 0.0 ? distance2 / cosine : 0.0;
}

/// What a surface point is made of, in its object's space.
struct ObjectPoint {
  DVec3 position;
  DVec3 normal;  ///< of any length
  Vec2 uv;
};

/// Uniform over the triangle (Turk 1990, "Generating Random Points in Triangles", Graphics Gems).
ObjectPoint sample_triangle(const geometry::Mesh& mesh, std::uint32_t triangle, Vec2 random) {
  const float root = std::sqrt(random.x);
  const Vec2 uv(root * (1.0f - random.y), root * random.y);
  const Edges edges = edges_of(mesh, triangle);
  return {edges.origin + static_cast<double>(uv.x) * edges.u + static_cast<double>(uv.y) * edges.v,
          cross(edges.u, edges.v), uv};
}

ObjectPoint sample_shape(const geometry::Shape& shape, const DVec3& from, Vec2 random) {
  const auto* sphere = std::get_if<geometry::Sphere>(&shape);
  const geometry::ShapePoint point =
      sphere != nullptr ? point_seen_from(*sphere, from, random) : uniform_point(shape, random);
  return {point.position, point.normal, Vec2(point.uv)};
}

}  // namespace

Emitters::Emitters(const shading::Scene& scene) : scene_(&scene) {
  const geometry::World& world = scene.world;
  std::vector<float> weights;
  first_.resize(world.instances.size());
  for_each_emissive(scene, [&](Hit hit, const geometry::Geometry& geometry) {
    if (!can_be_aimed_at(geometry)) return;
    first_[hit.instance].resize(
        world.objects[world.instances[hit.instance].object].geometries.size(), k_none);
    first_[hit.instance][hit.geometry] = static_cast<std::uint32_t>(emitters_.size());
    for (; hit.primitive < geometry.primitive_count(); ++hit.primitive) {
      const float area = area_of(scene, hit);
      emitters_.push_back({hit, area});
      weights.push_back(area > 0.0f ? area * mean_luminance(scene, hit) : 0.0f);
    }
  });
  if (!emitters_.empty()) distribution_.emplace(weights);
}

EmitterSample Emitters::sample(float choice, Vec2 random, const Vec3& from) const {
  const std::size_t index = distribution_->sample(choice).cell;
  EmitterSample result;
  result.hit = emitters_[index].hit;
  const geometry::Geometry& geometry = scene_->world.geometry(result.hit);
  const geometry::Transform& transform = scene_->world.transform(result.hit);
  const ObjectPoint point =
      geometry.mesh() != nullptr
          ? sample_triangle(*geometry.mesh(), result.hit.primitive, random)
          : sample_shape(*geometry.shape(), transform.point_to_object(DVec3(from)), random);
  result.uv = point.uv;
  result.position = Vec3(transform.point_to_world(point.position));
  result.normal = Vec3(normalize(transform.normal_to_world(point.normal)));
  result.pdf = direction_pdf(index, result.position, result.normal, from);
  return result;
}

float Emitters::pdf(const SurfacePoint& met, const Vec3& from) const {
  const Hit& hit = met.hit;
  if (emitters_.empty() || first_[hit.instance].empty()) return 0.0f;
  const std::uint32_t first = first_[hit.instance][hit.geometry];
  if (first == k_none) return 0.0f;
  return direction_pdf(first + hit.primitive, met.position, met.geometric_normal, from);
}

float Emitters::direction_pdf(std::size_t index, const Vec3& position, const Vec3& normal,
                              const Vec3& from) const {
  const Emitter& emitter = emitters_[index];
  if (!(emitter.area > 0.0f) || position == from) return 0.0f;
  const geometry::Shape* shape = scene_->world.geometry(emitter.hit).shape();
  const auto* sphere = shape != nullptr ? std::get_if<geometry::Sphere>(shape) : nullptr;
  const double pdf = sphere != nullptr
                         ? renderer::direction_pdf(*sphere, scene_->world.transform(emitter.hit),
                                                   DVec3(position), DVec3(normal), DVec3(from))
                         : steradian_to_area(DVec3(position), DVec3(normal), DVec3(from)) /
                               static_cast<double>(emitter.area);
  constexpr double k_largest = std::numeric_limits<float>::max();
  return static_cast<float>(
      std::min(pdf * static_cast<double>(distribution_->probability(index)), k_largest));
}

std::vector<Hit> unsampled_emitters(const shading::Scene& scene) {
  std::vector<Hit> hits;
  for_each_emissive(scene, [&](const Hit& hit, const geometry::Geometry& geometry) {
    if (!can_be_aimed_at(geometry)) hits.push_back(hit);
  });
  return hits;
}

}  // namespace lume::renderer
