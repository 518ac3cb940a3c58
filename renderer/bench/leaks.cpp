// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/leaks.h"

#include "renderer/bench/closed_mesh.h"
#include "renderer/bench/deadline.h"
#include "renderer/sampler.h"

#include <algorithm>
#include <array>
#include <optional>

namespace lume::renderer {
namespace {

using geometry::DVec3;
using geometry::Mesh;
using geometry::Ray;
using geometry::Transform;

/// A closed mesh in the scene.
struct Hull {
  const Mesh* mesh;
  const Transform* transform;
  bool faces_out;
};

std::vector<Hull> find_hulls(const geometry::World& world) {
  std::vector<Hull> hulls;
  for (std::size_t object = 0; object < world.objects.size(); ++object) {
    for (const geometry::Geometry& geometry : world.objects[object].geometries) {
      if (geometry.mesh() == nullptr || geometry.has_holes) continue;
      const ClosedMesh closed = examine_closed(*geometry.mesh());
      if (!closed.is_closed) continue;
      for (const geometry::Instance& instance : world.instances) {
        if (instance.object != object) continue;
        hulls.push_back({geometry.mesh(), &instance.transform, closed.faces_out});
      }
    }
  }
  return hulls;
}

/// The corners of a triangle in the scene, and a unit vector from it to the inside.
struct Wall {
  std::array<DVec3, 3> corners;
  DVec3 inward;
};

std::optional<Wall> wall_of(const Hull& hull, std::uint32_t triangle) {
  const auto corners = hull.mesh->corners(triangle);
  const DVec3 a(corners[0]), b(corners[1]), c(corners[2]);
  const DVec3 normal = hull.transform->normal_to_world(cross(b - a, c - a));
  const double size = length(normal);
  if (!(size > 0.0)) return std::nullopt;
  const auto place = [&](const DVec3& point) { return hull.transform->point_to_world(point); };
  return Wall{{place(a), place(b), place(c)}, normal / (hull.faces_out ? -size : size)};
}

/// Halfway from a triangle straight across to whatever is next: a place inside, well away from the
/// walls.
std::optional<Vec3> inside_of(const PreparedScene& prepared, const Wall& wall) {
  const auto& [a, b, c] = wall.corners;
  const DVec3 center = (a + b + c) / 3.0;
  const double step = 1e-4 * std::max({length(b - a), length(c - b), length(a - c)});
  const Ray across{.origin = Vec3(center + step * wall.inward), .direction = Vec3(wall.inward)};
  const auto hit = prepared.accelerator().closest_hit(across);
  if (!hit) return std::nullopt;
  const float t = prepared.point_at(across, *hit).t;
  return across.origin + 0.5f * t * across.direction;
}

/// A corner of the wall, or a point of one of its edges: half of the rays each.
Vec3 target_on(const Wall& wall, Vec2 random) {
  const auto corner = std::min(static_cast<std::size_t>(random.x * 3.0f), std::size_t{2});
  const DVec3& from = wall.corners[corner];
  const DVec3& to = wall.corners[(corner + 1) % 3];
  const double along = std::max(0.0, 2.0 * static_cast<double>(random.y) - 1.0);
  return from + (to - from) * along;
}

}  // namespace

std::vector<Ray> leak_rays(const PreparedScene& prepared, std::size_t count, std::uint64_t seed) {
  enum Dimension : std::uint32_t { k_place, k_aim, k_target };
  constexpr int k_row = -3;  // none of a picture's
  std::vector<Ray> rays;
  const std::vector<Hull> hulls = find_hulls(prepared.scene().world);
  if (hulls.empty()) return rays;
  rays.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Sampler sampler(seed, static_cast<int>(i), k_row, 0);
    const Hull& hull = hulls[i % hulls.size()];
    const auto pick = [&](float random) {
      const auto n = static_cast<float>(hull.mesh->triangles.size());
      return std::min(static_cast<std::uint32_t>(random * n),
                      static_cast<std::uint32_t>(hull.mesh->triangles.size() - 1));
    };
    const Vec2 random = sampler.get_2d(k_place);
    const auto from = wall_of(hull, pick(random.x));
    const auto to = wall_of(hull, pick(random.y));
    const auto origin = from ? inside_of(prepared, *from) : std::nullopt;
    if (!origin || !to) continue;
    const Vec3 target = target_on(*to, sampler.get_2d(k_target));
    if (target != *origin) rays.push_back({.origin = *origin, .direction = target - *origin});
  }
  return rays;
}

Leaks count_leaks(const geometry::Accelerator& accelerator, const std::vector<Ray>& rays,
                  double budget_seconds) {
  Leaks leaks;
  Deadline deadline(budget_seconds);
  for (const Ray& ray : rays) {
    if (deadline.is_over()) break;
    ++leaks.rays;
    if (!accelerator.closest_hit(ray)) ++leaks.missed_closest;
    if (!accelerator.any_hit(ray)) ++leaks.missed_any;
  }
  return leaks;
}

}  // namespace lume::renderer
