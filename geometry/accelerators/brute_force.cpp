// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/brute_force.h"

#include "geometry/refine.h"

namespace lume::geometry {
namespace {

class BruteForce final : public Accelerator {
 public:
  BruteForce(const World& world, const HoleTest* holes) : world_(world), holes_(holes) {}

  std::optional<Hit> closest_hit(const Ray& ray) const override {
    std::optional<Hit> closest;
    double closest_t = ray.t_max;
    for_each_hit(ray, [&](const Hit& hit, double t) {
      // Primitives come in order of identity, so of several at the same t the lowest wins.
      if (t < closest_t || (t == closest_t && !closest)) {
        closest = hit;
        closest_t = t;
      }
      return true;
    });
    return closest;
  }

  bool any_hit(const Ray& ray) const override {
    bool found = false;
    for_each_hit(ray, [&](const Hit&, double) {
      found = true;
      return false;
    });
    return found;
  }

  AcceleratorStats stats() const override { return AcceleratorStats(world_); }

 private:
  /// Calls visit(hit, t) for every primitive along the ray until it returns false.
  template <class Visit>
  void for_each_hit(const Ray& ray, const Visit& visit) const {
    if (!is_traceable(ray)) return;
    Hit hit;
    for (hit.instance = 0; hit.instance < world_.instances.size(); ++hit.instance) {
      const Object& object = world_.objects[world_.instances[hit.instance].object];
      const ObjectRay object_ray = to_object(world_.transform(hit), ray);
      for (hit.geometry = 0; hit.geometry < object.geometries.size(); ++hit.geometry) {
        const Mesh* mesh = object.geometries[hit.geometry].mesh();
        const bool go_on = mesh != nullptr ? visit_triangles(object_ray, *mesh, hit, visit)
                                           : visit_shape(object_ray, hit, visit);
        if (!go_on) return;
      }
    }
  }

  template <class Visit>
  bool visit_triangles(const ObjectRay& ray, const Mesh& mesh, Hit hit, const Visit& visit) const {
    for (hit.primitive = 0; hit.primitive < mesh.triangles.size(); ++hit.primitive) {
      const auto corners = mesh.corners(hit.primitive);
      const TriangleCrossing crossing = intersect_triangle(
          ray.origin, ray.direction, DVec3(corners[0]), DVec3(corners[1]), DVec3(corners[2]));
      if (!crossing.inside || !ray.contains(crossing.t) || is_hole(hit, crossing)) continue;
      if (!visit(hit, crossing.t)) return false;
    }
    return true;
  }

  template <class Visit>
  bool visit_shape(const ObjectRay& ray, Hit hit, const Visit& visit) const {
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

std::unique_ptr<Accelerator> make_brute_force(const World& world, const HoleTest* holes) {
  return std::make_unique<BruteForce>(world, holes);
}

}  // namespace lume::geometry
