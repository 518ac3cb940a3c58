// SPDX-License-Identifier: Apache-2.0
// Makes an accelerator of any structure that can sort boxes: one over the triangles of each object,
// built once, and one over what stands in the scene. The structure finds the candidates; whether
// and where they are met, which are holes, and which of two at the same place counts, is decided
// here for all structures alike, by the same numbers as in refine().
//
// A Structure is a class with
//   explicit Structure(const Items& items);
//   template <class Visit, class Cost>
//   bool traverse(const ObjectRay& ray, const Visit& visit, Cost& cost) const;
//       Calls visit(item) for every item whose box the ray meets within [t_min, t_max], the nearest
//       first as well as it can, until one says true; returns whether one did. visit may lower
//       ray.t_max, and boxes that begin beyond it (but not those that begin at it) can be left out.
//       The ray is finite, t_max may be infinite. cost.add_node() counts what is entered.
//   StructureStats stats() const;
// which must survive no items, one, items in one place, and items of size 0 or 1e38.
#pragma once

#include "geometry/accelerators/accelerator.h"
#include "geometry/accelerators/items.h"
#include "geometry/accelerators/nearest_hit.h"
#include "geometry/parallel.h"
#include "geometry/refine.h"

#include <chrono>
#include <deque>
#include <optional>

namespace lume::geometry {

template <class Structure>
class TwoLevel final : public Accelerator {
 public:
  TwoLevel(const World& world, const HoleTest* holes) : world_(world), holes_(holes) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<Bounds> of_triangles;
    of_triangles.reserve(world.objects.size());
    for (const Object& object : world.objects) {
      const TriangleItems& items = triangles_.emplace_back(object);
      of_triangles.push_back(items.all_bounds());
      lower_.emplace_back(items);
    }
    placements_.emplace(world, of_triangles);
    upper_.emplace(*placements_);
    build_seconds_ =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  std::optional<Hit> closest_hit(const Ray& ray) const override {
    NoCost none;
    return find_closest(ray, none);
  }
  bool any_hit(const Ray& ray) const override {
    NoCost none;
    return find_any(ray, none);
  }
  [[nodiscard]] bool counts_cost() const override { return true; }
  std::optional<Hit> closest_hit_counted(const Ray& ray, TraversalCost& cost) const override {
    return find_closest(ray, cost);
  }
  bool any_hit_counted(const Ray& ray, TraversalCost& cost) const override {
    return find_any(ray, cost);
  }

  AcceleratorStats stats() const override {
    AcceleratorStats stats(world_);
    stats.build_seconds = build_seconds_;
    for (const Structure& structure : lower_) stats.structure += structure.stats();
    stats.structure += upper_->stats();
    stats.memory_bytes = stats.structure.memory_bytes;
    return stats;
  }

 private:
  template <class Cost>
  std::optional<Hit> find_closest(const Ray& ray, Cost& cost) const {
    NearestHit nearest;
    visit_all(
        ray,
        [&nearest](const Hit& hit, double t, ObjectRay& here, ObjectRay& scene_ray) {
          if (!nearest.yields_to(hit, t)) return false;
          nearest = {hit, t};
          here.t_max = scene_ray.t_max = t;
          return false;
        },
        cost);
    return nearest.hit;
  }

  template <class Cost>
  bool find_any(const Ray& ray, Cost& cost) const {
    return visit_all(
        ray, [](const Hit&, double, ObjectRay&, ObjectRay&) { return true; }, cost);
  }

  /// Calls take(hit, t, ray in its object, ray in the scene) for crossings on the ray until one
  /// says true.
  template <class Take, class Cost>
  bool visit_all(const Ray& ray, const Take& take, Cost& cost) const {
    if (!is_traceable(ray)) return false;
    ObjectRay scene_ray{DVec3(ray.origin), DVec3(ray.direction), ray.t_min, ray.t_max};
    const auto visit = [&](const Placement& placement) {
      const Instance& instance = world_.instances[placement.instance];
      ObjectRay here = to_object(instance.transform, ray);
      here.t_max = scene_ray.t_max;
      if (placement.shape) return visit_shape(placement, here, scene_ray, take, cost);
      return visit_triangles(placement.instance, here, scene_ray, take, cost);
    };
    for (const Placement& placement : placements_->endless()) {
      if (visit(placement)) return true;
    }
    return upper_->traverse(
        scene_ray, [&](std::uint32_t i) { return visit(placements_->placement(i)); }, cost);
  }

  template <class Take, class Cost>
  bool visit_triangles(std::uint32_t instance, ObjectRay& ray, ObjectRay& scene_ray,
                       const Take& take, Cost& cost) const {
    const std::uint32_t object = world_.instances[instance].object;
    const TriangleItems& items = triangles_[object];
    const ShearedRay sheared(ray.origin, ray.direction);
    return lower_[object].traverse(
        ray,
        [&](std::uint32_t item) {
          cost.add_test();
          const auto corners = items.corners(item);
          const TriangleCrossing crossing =
              intersect_triangle(sheared, DVec3(corners[0]), DVec3(corners[1]), DVec3(corners[2]));
          if (!crossing.inside || !ray.contains(crossing.t)) return false;
          Hit hit = items.identity(item);
          hit.instance = instance;
          return !is_hole(hit, crossing) && take(hit, crossing.t, ray, scene_ray);
        },
        cost);
  }

  template <class Take, class Cost>
  bool visit_shape(const Placement& placement, ObjectRay& ray, ObjectRay& scene_ray,
                   const Take& take, Cost& cost) const {
    cost.add_test();
    Hit hit{placement.instance, *placement.shape, 0};
    const auto crossing = first_crossing(world_.geometry(hit), ray, hit, holes_);
    if (!crossing) return false;
    hit.primitive = crossing->part;
    return take(hit, crossing->t, ray, scene_ray);
  }

  [[nodiscard]] bool is_hole(const Hit& hit, const TriangleCrossing& crossing) const {
    return holes_ != nullptr && world_.geometry(hit).has_holes &&
           holes_->is_hole(hit, {static_cast<float>(crossing.u), static_cast<float>(crossing.v)});
  }

  const World& world_;
  const HoleTest* holes_;
  std::deque<TriangleItems> triangles_;  ///< by object
  std::deque<Structure> lower_;          ///< by object; none of both is ever moved
  std::optional<PlacementItems> placements_;
  std::optional<Structure> upper_;
  double build_seconds_ = 0.0;
};

/// As make_accelerator wants it.
template <class Structure>
[[nodiscard]] std::unique_ptr<Accelerator> make_two_level(const World& world, const HoleTest* holes,
                                                          const AcceleratorOptions& /*options*/) {
  return std::make_unique<TwoLevel<Structure>>(world, holes);
}

}  // namespace lume::geometry
