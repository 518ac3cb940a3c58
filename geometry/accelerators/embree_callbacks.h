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
#include <vector>

namespace lume::geometry {

/// One query. Embree hands this back to the functions below: the first member is what it knows, the
/// rest is ours.
struct EmbreeQuery {
  RTCIntersectContext embree{};
  const Ray* ray = nullptr;  ///< in the scene's frame; Embree's own copy is in object space by then
  const World* world = nullptr;
  const HoleTest* holes = nullptr;
  /// The nearest shape so far. Embree keeps distances as floats, and two shapes may be nearer to
  /// each other than those can tell.
  std::optional<Hit> nearest = std::nullopt;
  double nearest_t = std::numeric_limits<double>::infinity();
};

/// A shape where an instance has it.
struct PlacedShape {
  Hit hit;  ///< but for the primitive
  const Geometry* geometry = nullptr;
  const Transform* transform = nullptr;
};

/// What Embree's user primitives stand for, by primID. Their geometry's user pointer points here.
using PlacedShapes = std::vector<PlacedShape>;

/// The filter of meshes with holes, for closest and any hits alike. The barycentric coordinates are
/// refined first, so that the rim of a hole is the same under every accelerator.
void reject_holes(const RTCFilterFunctionNArguments* args);

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
