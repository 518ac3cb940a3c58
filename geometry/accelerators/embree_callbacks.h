// SPDX-License-Identifier: Apache-2.0
// What Embree asks back while it builds and traverses: the bounds of shapes, where a ray meets
// them, and which candidates are holes.
#pragma once

#include "geometry/hole_test.h"
#include "geometry/ray.h"
#include "geometry/world.h"

#include <embree3/rtcore.h>

#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace lume::geometry {

/// Meshes of instances that stand unmoved are attached to the scene itself, by consecutive numbers.
struct MergedMeshes {
  unsigned first_id = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> meshes;  ///< instance and geometry
};

/// One query. Embree hands this back to the functions below: the first member is what it knows, the
/// rest is ours.
struct EmbreeQuery {
  RTCIntersectContext embree{};
  const Ray* ray = nullptr;  ///< in the scene's frame; Embree's own copy is in object space by then
  const World* world = nullptr;
  const HoleTest* holes = nullptr;
  const MergedMeshes* merged = nullptr;
  /// The nearest so far of what was decided in double: shapes, and triangles unless Embree decides
  /// on those by itself. It keeps distances as floats, and two surfaces may be nearer to each other
  /// than those can tell.
  std::optional<Hit> nearest = std::nullopt;
  double nearest_t = std::numeric_limits<double>::infinity();
  /// Where the first triangle was that only a float's rounding lets the ray meet. If nothing else
  /// is met there, the ray may have slipped past the edge of its neighbour.
  double doubt_t = std::numeric_limits<double>::infinity();

  /// The identity that Embree's numbers stand for.
  [[nodiscard]] Hit identity(const RTCHit& hit) const {
    if (hit.instID[0] != RTC_INVALID_GEOMETRY_ID) return {hit.instID[0], hit.geomID, hit.primID};
    const auto& [instance, geometry] = merged->meshes[hit.geomID - merged->first_id];
    return {instance, geometry, hit.primID};
  }
};

/// A shape where an instance has it.
struct PlacedShape {
  Hit hit;  ///< but for the primitive
  const Geometry* geometry = nullptr;
  const Transform* transform = nullptr;
};

/// What Embree's user primitives stand for, by primID. Their geometry's user pointer points here.
using PlacedShapes = std::vector<PlacedShape>;

// The filters of meshes, which see every triangle that Embree finds; for single rays only.

/// Lets Embree decide on all but holes, for closest and any hits alike. The barycentric coordinates
/// are refined first, so that the rim of a hole is the same under every accelerator.
void reject_holes(const RTCFilterFunctionNArguments* args);
/// Decides in double, as every other accelerator does, whether the triangle is met and is nearest.
void take_if_exact(const RTCFilterFunctionNArguments* args);
/// The same for any hit.
void stop_if_exact(const RTCFilterFunctionNArguments* args);

// The functions of the user geometry.
void bound_shape(const RTCBoundsFunctionArguments* args);
void intersect_shape(const RTCIntersectFunctionNArguments* args);
void occlude_shape(const RTCOccludedFunctionNArguments* args);

/// Makes the shape the query's nearest hit if it is. Returns whether it is.
bool take_if_nearest(EmbreeQuery& query, const PlacedShape& shape, float t_max);
/// The nearest float that is not below nearest_t: what Embree may look at must reach to t itself.
[[nodiscard]] float nearest_tfar(const EmbreeQuery& query);
/// Whether the query's ray meets the shape at all.
[[nodiscard]] bool is_occluded(const EmbreeQuery& query, const PlacedShape& shape);

}  // namespace lume::geometry
