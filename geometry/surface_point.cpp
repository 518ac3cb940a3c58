// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lume::geometry {
namespace {

DVec3 absolute(const DMat3& m, const DVec3& v) {
  return glm::abs(m[0]) * v.x + glm::abs(m[1]) * v.y + glm::abs(m[2]) * v.z;
}

/// How far, along the normal, an accelerator that calculates in float may misplace a triangle as
/// seen by a ray that starts on it. Each sum and product contributes at most half a unit in the
/// last place of its operands: of the world position, of its way into object space, of the corners,
/// and all that brought back out. Never 0, or a ray would meet a plane through the origin that it
/// leaves.
float error_bound(const Transform& transform, const std::array<Vec3, 3>& corners,
                  const DVec3& world_point, const DVec3& normal) {
  constexpr double k_half_ulp = 0x1p-24;
  constexpr double k_steps = 8.0;  // roundings along the longest chain
  const DVec3 reach(
      glm::max(glm::max(glm::abs(corners[0]), glm::abs(corners[1])), glm::abs(corners[2])));
  const DVec3 inward = absolute(transform.inverse_linear(),
                                glm::abs(world_point) + glm::abs(transform.translation()));
  const DVec3 error = absolute(transform.linear(), reach + inward) + glm::abs(world_point);
  const double largest = std::max({error.x, error.y, error.z});
  return static_cast<float>(k_half_ulp * (k_steps * dot(glm::abs(normal), error) + largest));
}

/// The same for a shape, which every accelerator meets in double: what is left is that positions
/// are floats, when the ray's origin is stored and again when it is moved off the surface.
float rounding_bound(const DVec3& world_point) {
  constexpr double k_ulp = 0x1p-23;
  constexpr double k_roundings = 2.0;
  const DVec3 size = glm::abs(world_point);
  return static_cast<float>(k_roundings * k_ulp * (size.x + size.y + size.z)) +
         std::numeric_limits<float>::min();
}

/// The interpolated normal, or the geometric one where it vanishes; on the geometric one's side.
Vec3 shading_normal(const Mesh& mesh, const UVec3& corners, Vec2 uv, const Transform& transform,
                    const Vec3& geometric_normal) {
  if (mesh.normals.empty()) return geometric_normal;
  const Vec3 object_normal = interpolate(mesh.normals, corners, uv);
  const Vec3 n(transform.normal_to_world(DVec3(object_normal)));
  const float size = length(n);
  if (!(size > 0.0f)) return geometric_normal;
  return dot(n, geometric_normal) < 0.0f ? n / -size : n / size;
}

}  // namespace

Vec2 SurfacePoint::texcoord(std::uint32_t set) const {
  const Mesh* mesh = geometry->mesh();
  if (mesh == nullptr) return uv;
  if (set >= mesh->texcoords.size() || mesh->texcoords[set].empty()) return Vec2(0.0f);
  return interpolate(mesh->texcoords[set], mesh->triangles[hit.primitive], uv);
}

Vec4 SurfacePoint::color() const {
  const Mesh* mesh = geometry->mesh();
  if (mesh == nullptr || mesh->colors.empty()) return Vec4(1.0f);
  return interpolate(mesh->colors, mesh->triangles[hit.primitive], uv);
}

namespace {

/// The part that all surfaces have in common. `normal` is towards the front, of any length.
void place(SurfacePoint& point, const DVec3& world_point, const DVec3& normal,
           const DVec3& direction) {
  const double size = length(normal);
  const DVec3 unit = size > 0.0 ? normal / size : -normalize(direction);
  point.position = Vec3(world_point);
  point.shadow_origin = point.position;
  point.geometric_normal = Vec3(unit);
  point.front_facing = dot(unit, direction) <= 0.0;
}

void complete_triangle(const Mesh& mesh, const Transform& transform, const Ray& ray,
                       const Crossing& crossing, SurfacePoint& point) {
  // The point comes from the corners and not from the ray, whose length would multiply its error.
  const UVec3& corners = mesh.triangles[point.hit.primitive];
  const auto positions = mesh.corners(point.hit.primitive);
  const DVec3 edge1 = DVec3(positions[1]) - DVec3(positions[0]);
  const DVec3 edge2 = DVec3(positions[2]) - DVec3(positions[0]);
  const DVec3 object_point = DVec3(positions[0]) + crossing.u * edge1 + crossing.v * edge2;
  const DVec3 world_point = transform.point_to_world(object_point);
  place(point, world_point, transform.normal_to_world(cross(edge1, edge2)), DVec3(ray.direction));
  point.uv = {static_cast<float>(crossing.u), static_cast<float>(crossing.v)};
  point.normal = shading_normal(mesh, corners, point.uv, transform, point.geometric_normal);
  point.offset = error_bound(transform, positions, world_point, DVec3(point.geometric_normal));
}

void complete_shape(const Shape& shape, const Transform& transform, const Ray& ray,
                    const Crossing& crossing, bool textured, SurfacePoint& point) {
  const ObjectRay object_ray = to_object(transform, ray);
  const ShapePoint at = textured ? shape_point(shape, object_ray, crossing)
                                 : shape_place(shape, object_ray, crossing);
  const DVec3 world_point = transform.point_to_world(at.position);
  place(point, world_point, transform.normal_to_world(at.normal), DVec3(ray.direction));
  point.normal = point.geometric_normal;
  point.offset = rounding_bound(world_point);
  if (!textured) return;
  point.uv = Vec2(at.uv);
  point.dp_du = Vec3(transform.vector_to_world(at.dp_du));
  point.dp_dv = Vec3(transform.vector_to_world(at.dp_dv));
}

}  // namespace

SurfacePoint surface_point(const World& world, const Ray& ray, const Hit& hit,
                           const Crossing& crossing, bool textured) {
  SurfacePoint point;
  point.hit = hit;
  point.geometry = &world.geometry(hit);
  point.t = static_cast<float>(crossing.t);
  const Transform& transform = world.transform(hit);
  if (const Mesh* mesh = point.geometry->mesh()) {
    complete_triangle(*mesh, transform, ray, crossing, point);
  } else {
    complete_shape(*point.geometry->shape(), transform, ray, crossing, textured, point);
  }
  return point;
}

void lift_shadow_origin(const World& world, SurfacePoint& point) {
  const Mesh* mesh = point.geometry->mesh();
  if (mesh == nullptr || mesh->normals.empty()) return;
  const Transform& transform = world.transform(point.hit);
  const UVec3& corners = mesh->triangles[point.hit.primitive];
  const std::array weights = {1.0f - point.uv.x - point.uv.y, point.uv.x, point.uv.y};
  const Vec3 side = point.front_facing ? point.geometric_normal : -point.geometric_normal;
  for (int i = 0; i < 3; ++i) {
    // Where the point lies below the plane across a corner's normal, it is raised onto it; the
    // three corners' planes are blended by the barycentric coordinates.
    const Vec3 corner(transform.point_to_world(DVec3(mesh->positions[corners[i]])));
    Vec3 n(transform.normal_to_world(DVec3(mesh->normals[corners[i]])));
    const float size = length(n);
    if (!(size > 0.0f)) continue;
    n *= (dot(n, side) < 0.0f ? -1.0f : 1.0f) / size;
    const float height = std::max(0.0f, dot(corner - point.position, n));
    point.shadow_origin += weights[static_cast<std::size_t>(i)] * height * n;
  }
}

namespace {

/// Directions in which the texture coordinates grow (u) and fall (v), of any length.
struct ImageAxes {
  DVec3 along_u{0.0};
  DVec3 against_v{0.0};
};

/// Solves P_i - P_0 = dP/du (u_i - u_0) + dP/dv (v_i - v_0) for the two edges. The determinant's
/// size does not turn the directions, only its sign does.
ImageAxes solve_axes(const DVec3& edge1, const DVec3& edge2, const glm::dvec2& uv1,
                     const glm::dvec2& uv2) {
  const double sign = uv1.x * uv2.y - uv2.x * uv1.y < 0.0 ? -1.0 : 1.0;
  return {sign * (edge1 * uv2.y - edge2 * uv1.y), sign * (edge1 * uv2.x - edge2 * uv1.x)};
}

ImageAxes mesh_axes(const Mesh& mesh, const SurfacePoint& point, std::uint32_t set,
                    const glm::dmat2& uv_transform) {
  const UVec3& corners = mesh.triangles[point.hit.primitive];
  if (!mesh.tangents.empty()) {
    const Vec4 tangent = interpolate(mesh.tangents, corners, point.uv);
    const Vec3 normal = interpolate(mesh.normals, corners, point.uv);
    return {DVec3(Vec3(tangent)), DVec3(cross(normal, Vec3(tangent)) * tangent.w)};
  }
  if (set >= mesh.texcoords.size() || mesh.texcoords[set].empty()) return {};
  const auto [a, b, c] = mesh.corners(point.hit.primitive);
  const auto& uv = mesh.texcoords[set];
  return solve_axes(DVec3(b) - DVec3(a), DVec3(c) - DVec3(a),
                    uv_transform * (glm::dvec2(uv[corners.y]) - glm::dvec2(uv[corners.x])),
                    uv_transform * (glm::dvec2(uv[corners.z]) - glm::dvec2(uv[corners.x])));
}

}  // namespace

Frame tangent_frame(const World& world, const SurfacePoint& point, std::uint32_t set,
                    const glm::mat2& uv_transform) {
  const glm::dmat2 map(uv_transform);
  ImageAxes axes;
  if (const Mesh* mesh = point.geometry->mesh()) {
    const Transform& transform = world.transform(point.hit);
    axes = mesh_axes(*mesh, point, set, map);
    axes = {transform.vector_to_world(axes.along_u), transform.vector_to_world(axes.against_v)};
  } else {
    axes = solve_axes(DVec3(point.dp_du), DVec3(point.dp_dv), map[0], map[1]);
  }

  const Vec3 tangent(axes.along_u);
  const Vec3 in_plane = tangent - point.normal * dot(point.normal, tangent);
  const float size = length(in_plane);
  if (!(size > 1e-6f * length(tangent))) return make_frame(point.normal);
  Frame frame{in_plane / size, {}, point.normal};
  frame.bitangent = cross(frame.normal, frame.tangent);
  if (dot(frame.bitangent, Vec3(axes.against_v)) < 0.0f) frame.bitangent = -frame.bitangent;
  return frame;
}

namespace {

Vec3 step_off(const SurfacePoint& point, const Vec3& from, const Vec3& direction) {
  const float side = dot(direction, point.geometric_normal) < 0.0f ? -1.0f : 1.0f;
  return from + side * point.offset * point.geometric_normal;
}

/// The shadow origin holds on the side it was lifted to.
Vec3 shadow_ray_origin(const SurfacePoint& point, const Vec3& direction) {
  const bool to_front = dot(direction, point.geometric_normal) >= 0.0f;
  const Vec3& from = to_front == point.front_facing ? point.shadow_origin : point.position;
  return step_off(point, from, direction);
}

}  // namespace

Ray leave(const SurfacePoint& point, const Vec3& direction) {
  return {.origin = step_off(point, point.position, direction), .direction = direction};
}

Ray shadow_ray(const SurfacePoint& point, const Vec3& target) {
  constexpr float k_almost = 1.0f - 1e-4f;  // ends before the surface that may lie at the target
  const Vec3 origin = shadow_ray_origin(point, target - point.position);
  return {.origin = origin, .direction = target - origin, .t_max = k_almost};
}

Ray shadow_ray_along(const SurfacePoint& point, const Vec3& direction) {
  return {.origin = shadow_ray_origin(point, direction), .direction = direction};
}

}  // namespace lume::geometry
