// SPDX-License-Identifier: Apache-2.0
// Every ray against every primitive: the oracle that the other structures are tested against, with
// nothing in common with them but the primitives' own tests.
#include "geometry/accelerators/registry.h"
#include "geometry/refine.h"

namespace lume::geometry {
namespace {

class BruteForce final : public Accelerator {
 public:
  BruteForce(const World& world, const HoleTest* holes) : world_(world), holes_(holes) {}

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

  AcceleratorStats stats() const override { return AcceleratorStats(world_); }

 private:
  template <class Cost>
  std::optional<Hit> find_closest(const Ray& ray, Cost& cost) const {
    std::optional<Hit> closest;
    double closest_t = ray.t_max;
    for_each_hit(ray, cost, [&](const Hit& hit, double t) {
      // Primitives come in order of identity, so of several at the same t the lowest wins.
      if (t < closest_t || (t == closest_t && !closest)) {
        closest = hit;
        closest_t = t;
      }
      return true;
    });
    return closest;
  }

  template <class Cost>
  bool find_any(const Ray& ray, Cost& cost) const {
    bool found = false;
    for_each_hit(ray, cost, [&](const Hit&, double) {
      found = true;
      return false;
    });
    return found;
  }

  /// Calls visit(hit, t) for every primitive along the ray until it returns false.
  template <class Cost, class Visit>
  void for_each_hit(const Ray& ray, Cost& cost, const Visit& visit) const {
    if (!is_traceable(ray)) return;
    Hit hit;
    for (hit.instance = 0; hit.instance < world_.instances.size(); ++hit.instance) {
      const Object& object = world_.objects[world_.instances[hit.instance].object];
      const ObjectRay object_ray = to_object(world_.transform(hit), ray);
      for (hit.geometry = 0; hit.geometry < object.geometries.size(); ++hit.geometry) {
        const Mesh* mesh = object.geometries[hit.geometry].mesh();
        const bool go_on = mesh != nullptr ? visit_triangles(object_ray, *mesh, hit, cost, visit)
                                           : visit_shape(object_ray, hit, cost, visit);
        if (!go_on) return;
      }
    }
  }

  template <class Cost, class Visit>
  bool visit_triangles(const ObjectRay& ray, const Mesh& mesh, Hit hit, Cost& cost,
                       const Visit& visit) const {
    const ShearedRay sheared(ray.origin, ray.direction);
    for (hit.primitive = 0; hit.primitive < mesh.triangles.size(); ++hit.primitive) {
      cost.add_test();
      const auto corners = mesh.corners(hit.primitive);
      const TriangleCrossing crossing =
          intersect_triangle(sheared, DVec3(corners[0]), DVec3(corners[1]), DVec3(corners[2]));
      if (!crossing.inside || !ray.contains(crossing.t) || is_hole(hit, crossing)) continue;
      if (!visit(hit, crossing.t)) return false;
    }
    return true;
  }

  template <class Cost, class Visit>
  bool visit_shape(const ObjectRay& ray, Hit hit, Cost& cost, const Visit& visit) const {
    cost.add_test();
    const auto crossing = first_crossing(world_.geometry(hit), ray, hit, holes_);
    if (!crossing) return true;
    hit.primitive = crossing->part;
    return visit(hit, crossing->t);
  }

  [[nodiscard]] bool is_hole(const Hit& hit, const TriangleCrossing& crossing) const {
    return world_.geometry(hit).has_holes && holes_ != nullptr &&
           holes_->is_hole(hit, {static_cast<float>(crossing.u), static_cast<float>(crossing.v)});
  }

  const World& world_;
  const HoleTest* holes_;
};

}  // namespace

std::unique_ptr<Accelerator> make_brute_force(const World& world, const HoleTest* holes,
                                              const AcceleratorOptions& /*options*/) {
  return std::make_unique<BruteForce>(world, holes);
}

}  // namespace lume::geometry
