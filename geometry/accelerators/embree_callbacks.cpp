// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/embree_callbacks.h"

#include "geometry/refine.h"

#include <algorithm>
#include <cmath>

namespace lume::geometry {
namespace {

EmbreeQuery& query_of(RTCIntersectContext* context) {
  return *reinterpret_cast<EmbreeQuery*>(context);
}

const PlacedShape& placed_shape(const void* user_pointer, unsigned index) {
  return (*static_cast<const PlacedShapes*>(user_pointer))[index];
}

/// Where the query's ray meets a triangle that is no hole there; raises a doubt where only a float
/// lets it.
std::optional<double> exact_crossing(EmbreeQuery& query, const Hit& hit) {
  const World& world = *query.world;
  const ObjectRay ray = to_object(world.transform(hit), *query.ray);
  const auto corners = world.geometry(hit).mesh()->corners(hit.primitive);
  const TriangleCrossing crossing = nearest_on_triangle(
      ray.origin, ray.direction, DVec3(corners[0]), DVec3(corners[1]), DVec3(corners[2]));
  if (!ray.contains(crossing.t)) return std::nullopt;
  if (!crossing.inside) {
    query.doubt_t = std::min(query.doubt_t, crossing.t);
    return std::nullopt;
  }
  const Vec2 uv(static_cast<float>(crossing.u), static_cast<float>(crossing.v));
  const bool may_be_hole = query.holes != nullptr && world.geometry(hit).has_holes;
  if (may_be_hole && query.holes->is_hole(hit, uv)) return std::nullopt;
  return crossing.t;
}

}  // namespace

void reject_holes(const RTCFilterFunctionNArguments* args) {
  const EmbreeQuery& query = query_of(args->context);
  const Hit hit = query.identity(*reinterpret_cast<const RTCHit*>(args->hit));
  const Crossing crossing = refine(*query.world, *query.ray, hit, nullptr);
  const Vec2 uv(static_cast<float>(crossing.u), static_cast<float>(crossing.v));
  if (query.holes->is_hole(hit, uv)) args->valid[0] = 0;
}

void take_if_exact(const RTCFilterFunctionNArguments* args) {
  EmbreeQuery& query = query_of(args->context);
  auto& ray = *reinterpret_cast<RTCRay*>(args->ray);
  const Hit hit = query.identity(*reinterpret_cast<const RTCHit*>(args->hit));
  const auto t = exact_crossing(query, hit);
  const bool is_nearest =
      t &&
      (*t < query.nearest_t || (*t == query.nearest_t && (!query.nearest || hit < *query.nearest)));
  if (!is_nearest) {
    args->valid[0] = 0;
    return;
  }
  query.nearest = hit;
  query.nearest_t = *t;
  // Embree's own distance is rounded: one that is a little nearer may seem to be farther.
  constexpr float k_rounding = 1e-4f;
  ray.tfar = std::min(query.ray->t_max, nearest_tfar(query) * (1.0f + k_rounding));
}

void stop_if_exact(const RTCFilterFunctionNArguments* args) {
  EmbreeQuery& query = query_of(args->context);
  const Hit hit = query.identity(*reinterpret_cast<const RTCHit*>(args->hit));
  if (!exact_crossing(query, hit)) args->valid[0] = 0;
}

void bound_shape(const RTCBoundsFunctionArguments* args) {
  const PlacedShape& placed = placed_shape(args->geometryUserPtr, args->primID);
  const Bounds bounds = shape_bounds(*placed.geometry->shape(), *placed.transform);
  *args->bounds_o = {bounds.lower.x, bounds.lower.y, bounds.lower.z, 0.0f,
                     bounds.upper.x, bounds.upper.y, bounds.upper.z, 0.0f};
}

float nearest_tfar(const EmbreeQuery& query) {
  const auto nearest = static_cast<float>(query.nearest_t);
  return static_cast<double>(nearest) >= query.nearest_t
             ? nearest
             : std::nextafter(nearest, std::numeric_limits<float>::infinity());
}

bool take_if_nearest(EmbreeQuery& query, const PlacedShape& shape, float t_max) {
  ObjectRay ray = to_object(*shape.transform, *query.ray);
  ray.t_max = std::min(static_cast<double>(t_max), query.nearest_t);
  const auto crossing = first_crossing(*shape.geometry, ray, shape.hit, query.holes);
  if (!crossing) return false;
  const Hit hit{shape.hit.instance, shape.hit.geometry, crossing->part};
  // Of several at the same place the lowest identity is met.
  if (crossing->t == query.nearest_t && query.nearest && *query.nearest < hit) return false;
  query.nearest = hit;
  query.nearest_t = crossing->t;
  return true;
}

bool is_occluded(const EmbreeQuery& query, const PlacedShape& shape) {
  const ObjectRay ray = to_object(*shape.transform, *query.ray);
  if (shape.geometry->has_holes) {
    return first_crossing(*shape.geometry, ray, shape.hit, query.holes).has_value();
  }
  return meets(*shape.geometry->shape(), ray);
}

void intersect_shape(const RTCIntersectFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  EmbreeQuery& query = query_of(args->context);
  auto& state = *reinterpret_cast<RTCRayHit*>(args->rayhit);
  const PlacedShape& shape = placed_shape(args->geometryUserPtr, args->primID);
  if (!take_if_nearest(query, shape, state.ray.tfar)) return;
  state.ray.tfar = nearest_tfar(query);
  state.hit.instID[0] = query.nearest->instance;
  state.hit.geomID = query.nearest->geometry;
  state.hit.primID = query.nearest->primitive;
}

void occlude_shape(const RTCOccludedFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  const EmbreeQuery& query = query_of(args->context);
  auto& ray = *reinterpret_cast<RTCRay*>(args->ray);
  const PlacedShape& shape = placed_shape(args->geometryUserPtr, args->primID);
  if (is_occluded(query, shape)) ray.tfar = -std::numeric_limits<float>::infinity();
}

}  // namespace lume::geometry
