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

  AcceleratorStats stats() const override {
    AcceleratorStats stats;
    stats.instances = world_.instances.size();
    for (const Object& object : world_.objects) {
      for (const Mesh& mesh : object.geometries) stats.primitives += mesh.triangles.size();
    }
    return stats;
  }

 private:
  /// Calls visit(hit, t) for every primitive along the ray until it returns false.
  template <class Visit>
  void for_each_hit(const Ray& ray, const Visit& visit) const {
    if (!is_traceable(ray)) return;
    Hit hit;
    for (hit.instance = 0; hit.instance < world_.instances.size(); ++hit.instance) {
      const Object& object = world_.objects[world_.instances[hit.instance].object];
      for (hit.geometry = 0; hit.geometry < object.geometries.size(); ++hit.geometry) {
        const Mesh& mesh = object.geometries[hit.geometry];
        for (hit.primitive = 0; hit.primitive < mesh.triangles.size(); ++hit.primitive) {
          const Crossing crossing = refine(world_, ray, hit);
          const bool within = crossing.t >= ray.t_min && crossing.t <= ray.t_max;
          if (!crossing.inside || !within || is_hole(mesh, hit, crossing)) continue;
          if (!visit(hit, crossing.t)) return;
        }
      }
    }
  }

  [[nodiscard]] bool is_hole(const Mesh& mesh, const Hit& hit, const Crossing& crossing) const {
    return mesh.has_holes && holes_ != nullptr &&
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
