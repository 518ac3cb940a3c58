// SPDX-License-Identifier: Apache-2.0
#include "renderer/prepared_scene.h"

#include "shading/alpha_mask.h"

#include <algorithm>

namespace lume::renderer {
namespace {

/// Whether any surface in the scene has a material of the kind.
template <class Kind>
bool any_material(const shading::Scene& scene, const Kind& is_of_kind) {
  for (const geometry::Object& object : scene.world.objects) {
    for (const geometry::Geometry& geometry : object.geometries) {
      if (is_of_kind(scene.materials[geometry.material])) return true;
    }
  }
  return false;
}

}  // namespace

PreparedScene::PreparedScene(const shading::Scene& scene, std::string_view accelerator)
    : PreparedScene(scene, [&](const geometry::World& world, const geometry::HoleTest* holes) {
        return geometry::make_accelerator(accelerator, world, holes);
      }) {}

PreparedScene::PreparedScene(const shading::Scene& scene,
                             const AcceleratorFactory& make_accelerator)
    : scene_(scene),
      holes_(std::make_unique<shading::AlphaMask>(scene)),
      accelerator_(make_accelerator(scene.world, holes_.get())),
      emitters_(scene),
      has_see_through_(
          any_material(scene, [](const auto& material) { return material.is_see_through(); })),
      has_one_way_(
          any_material(scene, [](const auto& material) { return material.is_one_way(); })) {}

geometry::SurfacePoint PreparedScene::point_at(const geometry::Ray& ray,
                                               const geometry::Hit& hit) const {
  return surface_point(scene_.world, ray, hit, crossing_at(ray, hit), material(hit).is_textured());
}

std::optional<geometry::SurfacePoint> PreparedScene::first_surface(geometry::Ray ray) const {
  constexpr int k_most_culled = 10000;  // each step moves on, but a lie in a file must not hang us
  float t_before = 0.0f;
  for (int culled = 0; culled < k_most_culled; ++culled) {
    const auto hit = accelerator_->closest_hit(ray);
    if (!hit) return std::nullopt;
    geometry::SurfacePoint point = point_at(ray, *hit);
    point.t += t_before;
    if (point.front_facing || !material(*hit).is_one_way()) {
      lift_shadow_origin(scene_.world, point);
      return point;
    }
    t_before = point.t;
    ray = leave(point, ray.direction);
  }
  return std::nullopt;
}

}  // namespace lume::renderer
