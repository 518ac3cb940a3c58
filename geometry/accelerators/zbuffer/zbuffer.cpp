// SPDX-License-Identifier: Apache-2.0
// Visibility in the order of objects instead of rays: once a camera is known, the whole scene is
// drawn into a raster, and a ray of that camera then looks at nothing but the few things in its
// cell. Where exactly it meets them, the same test says as for every other structure, so the
// picture is the same to the bit. All other rays, of shadows and mirrors, know no raster and go to
// a hierarchy.
#include "geometry/accelerators/registry.h"
#include "geometry/accelerators/two_level.h"
#include "geometry/accelerators/zbuffer/raster.h"

#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>

namespace lume::geometry {
namespace zbuffer {
namespace {

/// Of a pinhole camera that sees something, a picture that is worth its memory.
bool can_draw(const Camera& camera, int width, int height) {
  constexpr std::int64_t k_most_pixels = std::int64_t{1} << 26U;  // four bytes each
  const bool is_perspective = camera.projection == Camera::Projection::perspective;
  const float size = is_perspective ? camera.vertical_fov : camera.half_height;
  return camera.lens_radius == 0.0f && width > 0 && height > 0 &&
         std::int64_t{width} * height <= k_most_pixels && size > 0.0f && std::isfinite(size) &&
         is_finite(camera.position);
}

/// A ray in the space of the placement that it is in.
struct PlacedRay {
  PlacedRay(const Transform& transform, const Ray& ray)
      : object_ray(to_object(transform, ray)), sheared(object_ray.origin, object_ray.direction) {}

  ObjectRay object_ray;
  ShearedRay sheared;
};

class ZBuffer final : public Accelerator {
 public:
  ZBuffer(const World& world, const HoleTest* holes)
      : world_(world), holes_(holes), other_rays_(make_accelerator("bvh-sah", world, holes)) {
    const auto start = std::chrono::steady_clock::now();
    items_.emplace(world);
    add_time_since(start);
    seconds_ += other_rays_->stats().build_seconds;
  }

  void prepare_view(const Camera& camera, int width, int height) override {
    const auto start = std::chrono::steady_clock::now();
    raster_.reset();
    if (!can_draw(camera, width, height)) return;
    view_.emplace(camera, width, height);
    raster_ = Raster::draw(*items_, *view_);
    add_time_since(start);
  }

  std::optional<Hit> closest_hit(const Ray& ray) const override {
    NoCost none;
    const auto in_view = find(ray);
    return in_view ? find_closest(ray, *in_view, none) : other_rays_->closest_hit(ray);
  }
  bool any_hit(const Ray& ray) const override {
    NoCost none;
    const auto in_view = find(ray);
    return in_view ? find_any(ray, *in_view, none) : other_rays_->any_hit(ray);
  }
  [[nodiscard]] bool counts_cost() const override { return true; }
  std::optional<Hit> closest_hit_counted(const Ray& ray, TraversalCost& cost) const override {
    const auto in_view = find(ray);
    return in_view ? find_closest(ray, *in_view, cost)
                   : other_rays_->closest_hit_counted(ray, cost);
  }
  bool any_hit_counted(const Ray& ray, TraversalCost& cost) const override {
    const auto in_view = find(ray);
    return in_view ? find_any(ray, *in_view, cost) : other_rays_->any_hit_counted(ray, cost);
  }

  /// Of the raster, if there is one; the memory is that of everything.
  [[nodiscard]] AcceleratorStats stats() const override {
    AcceleratorStats stats(world_);
    stats.build_seconds = seconds_;
    if (raster_) stats.structure = raster_->stats();
    stats.memory_bytes =
        stats.structure.memory_bytes + items_->memory_bytes() + other_rays_->stats().memory_bytes;
    return stats;
  }

 private:
  void add_time_since(std::chrono::steady_clock::time_point start) {
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  [[nodiscard]] std::optional<ViewRay> find(const Ray& ray) const {
    return raster_ && is_traceable(ray) ? view_->find(ray) : std::nullopt;
  }

  template <class Cost>
  std::optional<Hit> find_closest(const Ray& ray, const ViewRay& in_view, Cost& cost) const {
    NearestHit nearest;
    double end = ray.t_max;
    visit_candidates(
        ray, in_view, end,
        [&nearest, &end](const Hit& hit, double t) {
          if (nearest.yields_to(hit, t)) {
            nearest = {hit, t};
            end = t;
          }
          return false;
        },
        cost);
    return nearest.hit;
  }

  template <class Cost>
  bool find_any(const Ray& ray, const ViewRay& in_view, Cost& cost) const {
    const double end = ray.t_max;
    return visit_candidates(
        ray, in_view, end, [](const Hit&, double) { return true; }, cost);
  }

  /// Calls take(hit, t) for what the ray meets up to t = `end`, which take may lower, until it says
  /// true.
  template <class Take, class Cost>
  bool visit_candidates(const Ray& ray, const ViewRay& in_view, const double& end, const Take& take,
                        Cost& cost) const {
    for (const Placement& placement : items_->placements().endless()) {
      if (visit_shape(placement, ray, end, take, cost)) return true;
    }
    cost.add_node();
    ItemRange range;
    std::optional<PlacedRay> placed;
    for (const Candidate& candidate : raster_->candidates(in_view.cell)) {
      const double depth = in_view.depth(end);
      const double nearness = view_->is_perspective() ? 1.0 / depth : -depth;
      if (static_cast<double>(candidate.nearness) < nearness) return false;
      if (!placed || candidate.item < range.first || candidate.item >= range.last) {
        range = items_->range_of(candidate.item);
        placed.emplace(items_->transform(range.placement), ray);
      }
      placed->object_ray.t_max = end;
      if (items_->is_shape(range.placement)
              ? visit_shape(items_->placements().placement(range.placement), ray, end, take, cost)
              : visit_triangle(items_->identity(range, candidate.item), *placed, take, cost)) {
        return true;
      }
    }
    return false;
  }

  template <class Take, class Cost>
  bool visit_triangle(const Hit& hit, const PlacedRay& ray, const Take& take, Cost& cost) const {
    cost.add_test();
    const auto corners = items_->corners(hit);
    const TriangleCrossing crossing =
        intersect_triangle(ray.sheared, DVec3(corners[0]), DVec3(corners[1]), DVec3(corners[2]));
    if (!crossing.inside || !ray.object_ray.contains(crossing.t)) return false;
    const bool is_hole =
        holes_ != nullptr && items_->has_holes(hit) &&
        holes_->is_hole(hit, {static_cast<float>(crossing.u), static_cast<float>(crossing.v)});
    return !is_hole && take(hit, crossing.t);
  }

  template <class Take, class Cost>
  bool visit_shape(const Placement& placement, const Ray& ray, double end, const Take& take,
                   Cost& cost) const {
    cost.add_test();
    Hit hit{placement.instance, *placement.shape, 0};
    ObjectRay object_ray = to_object(world_.transform(hit), ray);
    object_ray.t_max = end;
    const auto crossing = first_crossing(world_.geometry(hit), object_ray, hit, holes_);
    if (!crossing) return false;
    hit.primitive = crossing->part;
    return take(hit, crossing->t);
  }

  const World& world_;
  const HoleTest* holes_;
  std::unique_ptr<Accelerator> other_rays_;
  std::optional<SceneItems> items_;
  std::optional<View> view_;
  std::optional<Raster> raster_;  ///< none: all rays are other rays
  double seconds_ = 0.0;
};

}  // namespace
}  // namespace zbuffer

std::unique_ptr<Accelerator> make_zbuffer(const World& world, const HoleTest* holes,
                                          const AcceleratorOptions& /*options*/) {
  return std::make_unique<zbuffer::ZBuffer>(world, holes);
}

}  // namespace lume::geometry
