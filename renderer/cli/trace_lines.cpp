// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/trace_report.h"
#include "renderer/cli/trace_terms.h"

namespace lume::cli {
namespace {

using geometry::Vec3;

/// How long rays without an end are drawn (metres): out of the scene, seen from anywhere in it.
float reach(const TraceReport& report) {
  geometry::Bounds bounds = report.scene.world.bounds();
  if (!bounds.is_finite()) bounds = {};
  for (const renderer::RayNote& ray : report.tree().rays) {
    bounds.add(ray.ray.origin);
    for (const renderer::SurfaceNote& surface : ray.surfaces) bounds.add(surface.point.position);
  }
  const float diagonal = 2.0f * bounds.radius();
  return diagonal > 0.0f ? 2.0f * diagonal : 1.0f;
}

std::size_t group_of(const RayLook& look) {
  return static_cast<std::size_t>(&look - k_ray_looks.data());
}

}  // namespace

std::vector<io::LineGroup> trace_to_lines(const TraceReport& report) {
  std::vector<io::LineGroup> groups;
  for (const RayLook& look : k_ray_looks) {
    io::LineGroup& group = groups.emplace_back();
    group.name = look.name;
    for (int i = 0; i < 3; ++i) {
      group.color[i] = shading::srgb_to_linear(
          static_cast<float>(look.srgb[static_cast<std::size_t>(i)]) / 255.0f);
    }
  }
  const float far = reach(report);
  const auto add = [&](const RayLook& look, const Vec3& from, const Vec3& to) {
    if (geometry::is_finite(from) && geometry::is_finite(to))
      groups[group_of(look)].segments.push_back({from, to});
  };
  for (const renderer::RayNote& note : report.tree().rays) {
    const geometry::Ray& ray = note.ray;
    const Vec3 end = leaves_scene(report.scene, note) ? ray.origin + far * ray.direction
                                                      : note.surfaces.back().point.position;
    add(look_of(note.kind), ray.origin, end);
  }
  for (const renderer::LightNote& note : report.tree().lights) {
    const Vec3& origin = note.ray.origin;
    add(look_of(note), origin, light_position(note).value_or(origin + far * note.ray.direction));
  }
  return groups;
}

}  // namespace lume::cli
