// SPDX-License-Identifier: Apache-2.0
// A plugin behind the Accelerator interface. The plugin answers for the triangles of an object;
// instances, shapes and holes are dealt with here, and what it names is looked at before it counts.
#include "geometry/accelerators/plugin/plugin.h"

#include "geometry/accelerators/bvh/binned_sah.h"
#include "geometry/accelerators/bvh/box.h"
#include "geometry/accelerators/bvh/hierarchy.h"
#include "geometry/accelerators/nearest_hit.h"
#include "geometry/accelerators/plugin/plugin_library.h"
#include "geometry/refine.h"

#include <chrono>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>

namespace lume::geometry {
namespace {

using Upper = bvh::Hierarchy<bvh::Box, bvh::build_binned_sah>;

LumeRay plugin_ray(const ObjectRay& ray) {
  const Vec3 o(ray.origin);
  const Vec3 d(ray.direction);
  return {{o.x, o.y, o.z},
          static_cast<float>(ray.t_min),
          {d.x, d.y, d.z},
          static_cast<float>(ray.t_max)};
}

class Plugin final : public Accelerator {
 public:
  Plugin(const std::string& file, const World& world, const HoleTest* holes)
      : world_(world), holes_(holes), library_(file) {
    std::vector<Bounds> of_triangles;
    of_triangles.reserve(world.objects.size());
    std::chrono::duration<double> building{};
    for (const Object& object : world.objects) {
      const TriangleItems& items = triangles_.emplace_back(object);
      of_triangles.push_back(items.all_bounds());
      const auto start = std::chrono::steady_clock::now();
      structures_.emplace_back(library_, items);
      building += std::chrono::steady_clock::now() - start;
    }
    placements_.emplace(world, of_triangles);
    upper_.emplace(*placements_);
    build_seconds_ = building.count();
  }

  std::optional<Hit> closest_hit(const Ray& ray) const override {
    NearestHit nearest;
    visit_placements(ray, [&](const Placement& placement, ObjectRay& here, ObjectRay& scene_ray) {
      const auto found =
          placement.shape ? shape_hit(placement, here) : triangle_hit(placement.instance, here);
      if (!found || !nearest.yields_to(*found->hit, found->t)) return false;
      nearest = *found;
      scene_ray.t_max = found->t;
      return false;
    });
    return nearest.hit;
  }

  bool any_hit(const Ray& ray) const override {
    return visit_placements(ray, [&](const Placement& placement, ObjectRay& here, ObjectRay&) {
      if (placement.shape) return shape_hit(placement, here).has_value();
      const std::uint32_t object = world_.instances[placement.instance].object;
      if (has_holes(object)) return triangle_hit(placement.instance, here).has_value();
      const LumeRay query = plugin_ray(here);
      const void* const structure = structures_[object].get();
      return structure != nullptr && library_.table().any_hit(structure, &query) != 0;
    });
  }

  AcceleratorStats stats() const override {
    AcceleratorStats stats(world_);
    stats.build_seconds = build_seconds_;
    for (const PluginStructure& structure : structures_) {
      stats.memory_bytes += structure.memory_bytes();
    }
    return stats;
  }

 private:
  template <class Visit>
  bool visit_placements(const Ray& ray, const Visit& visit) const {
    if (!is_traceable(ray) || ray.direction == Vec3(0.0f)) return false;
    ObjectRay scene_ray{DVec3(ray.origin), DVec3(ray.direction), ray.t_min, ray.t_max};
    const auto ask = [&](const Placement& placement) {
      ObjectRay here = to_object(world_.instances[placement.instance].transform, ray);
      here.t_max = scene_ray.t_max;
      return visit(placement, here, scene_ray);
    };
    for (const Placement& placement : placements_->endless()) {
      if (ask(placement)) return true;
    }
    NoCost none;
    return upper_->traverse(
        scene_ray, [&](std::uint32_t i) { return ask(placements_->placement(i)); }, none);
  }

  [[nodiscard]] std::optional<NearestHit> shape_hit(const Placement& placement,
                                                    const ObjectRay& ray) const {
    Hit hit{placement.instance, *placement.shape, 0};
    const auto crossing = first_crossing(world_.geometry(hit), ray, hit, holes_);
    if (!crossing) return std::nullopt;
    hit.primitive = crossing->part;
    return NearestHit{hit, crossing->t};
  }

  [[nodiscard]] std::optional<NearestHit> triangle_hit(std::uint32_t instance,
                                                       ObjectRay ray) const {
    constexpr int k_most_holes = 10000;
    const std::uint32_t object = world_.instances[instance].object;
    if (structures_[object].get() == nullptr) return std::nullopt;
    for (int i = 0; i < k_most_holes; ++i) {
      const LumeRay query = plugin_ray(ray);
      LumeHit found{};
      if (library_.table().closest_hit(structures_[object].get(), &query, &found) == 0) break;
      const TriangleCrossing crossing = look_at(found, object, ray, query);
      Hit hit = triangles_[object].identity(found.triangle);
      hit.instance = instance;
      if (!is_hole(hit, crossing)) return NearestHit{hit, crossing.t};
      const double t = std::max(crossing.t, static_cast<double>(found.t));
      ray.t_min = std::nextafter(static_cast<float>(t), std::numeric_limits<float>::infinity());
      if (!(ray.t_min <= ray.t_max)) break;
    }
    return std::nullopt;
  }

  /// Where the ray meets what the plugin named. It decides in float, so its ray may pass the
  /// triangle by what floats cannot tell, but not by a thousandth of all sizes there are.
  [[nodiscard]] TriangleCrossing look_at(const LumeHit& found, std::uint32_t object,
                                         const ObjectRay& ray, const LumeRay& query) const {
    const TriangleItems& items = triangles_[object];
    if (found.triangle >= items.size()) {
      library_.fail("names triangle " + std::to_string(found.triangle) + " of " +
                    std::to_string(items.size()));
    }
    if (!(found.t >= query.t_min && found.t <= query.t_max)) {
      library_.fail("meets triangle " + std::to_string(found.triangle) + " at t " +
                    std::to_string(found.t) + ", which is not on the ray");
    }
    const auto corners = items.corners(found.triangle);
    const TriangleCrossing crossing = nearest_on_triangle(
        ray.origin, ray.direction, DVec3(corners[0]), DVec3(corners[1]), DVec3(corners[2]));
    if (crossing.inside) return crossing;
    constexpr double k_tolerance = 1e-3;
    const DVec3 point = (1.0 - crossing.u - crossing.v) * DVec3(corners[0]) +
                        crossing.u * DVec3(corners[1]) + crossing.v * DVec3(corners[2]);
    const double size = length(ray.origin) + length(point);
    const double distance = length(ray.at(crossing.t) - point);
    if (!(distance <= k_tolerance * size)) {
      library_.fail("names triangle " + std::to_string(found.triangle) +
                    ", which the ray passes by at a distance of " + std::to_string(distance));
    }
    return crossing;
  }

  [[nodiscard]] bool has_holes(std::uint32_t object) const {
    if (holes_ == nullptr) return false;
    for (const Geometry& geometry : world_.objects[object].geometries) {
      if (geometry.has_holes) return true;
    }
    return false;
  }
  [[nodiscard]] bool is_hole(const Hit& hit, const TriangleCrossing& crossing) const {
    return holes_ != nullptr && world_.geometry(hit).has_holes &&
           holes_->is_hole(hit, {static_cast<float>(crossing.u), static_cast<float>(crossing.v)});
  }

  const World& world_;
  const HoleTest* holes_;
  PluginLibrary library_;
  std::deque<TriangleItems> triangles_;     ///< by object
  std::deque<PluginStructure> structures_;  ///< by object
  std::optional<PlacementItems> placements_;
  std::optional<Upper> upper_;
  double build_seconds_ = 0.0;
};

}  // namespace

std::unique_ptr<Accelerator> make_plugin(const std::string& file, const World& world,
                                         const HoleTest* holes) {
  return std::make_unique<Plugin>(file, world, holes);
}

}  // namespace lume::geometry
