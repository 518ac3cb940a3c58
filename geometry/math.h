// SPDX-License-Identifier: Apache-2.0
// The few names that all of Lume takes from glm. Vectors are columns and matrices multiply from the
// left (M * v), as in the course.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cstdint>
#include <numbers>

namespace lume::geometry {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;
using Mat3 = glm::mat3;
using DVec3 = glm::dvec3;
using DMat3 = glm::dmat3;
using DMat4 = glm::dmat4;
using UVec3 = glm::uvec3;
using glm::cross;
using glm::dot;
using glm::length;
using glm::normalize;

inline constexpr float k_pi = std::numbers::pi_v<float>;

/// True if no component is infinite or NaN.
[[nodiscard]] inline bool is_finite(const Vec3& v) {
  // A sum of products with zero is 0 for finite components and NaN for all others.
  return v.x * 0.0f + v.y * 0.0f + v.z * 0.0f == 0.0f;
}

/// The axis along which a vector is longest.
[[nodiscard]] inline int dominant_axis(const DVec3& v) {
  const DVec3 size = glm::abs(v);
  if (size.x > size.y) return size.x > size.z ? 0 : 2;
  return size.y > size.z ? 1 : 2;
}

/// An orthonormal frame; `normal` is its third axis, so local z is the height above a surface.
struct Frame {
  Vec3 tangent;
  Vec3 bitangent;
  Vec3 normal;

  [[nodiscard]] Vec3 to_local(const Vec3& v) const {
    return {dot(v, tangent), dot(v, bitangent), dot(v, normal)};
  }
  [[nodiscard]] Vec3 to_world(const Vec3& v) const {
    return tangent * v.x + bitangent * v.y + normal * v.z;
  }
};

/// A frame around a unit normal without branches on its direction (Duff et al. 2017, "Building an
/// Orthonormal Basis, Revisited", listing 3).
[[nodiscard]] inline Frame make_frame(const Vec3& n) {
  const float sign = n.z < 0.0f ? -1.0f : 1.0f;
  const float a = -1.0f / (sign + n.z);
  const float b = n.x * n.y * a;
  return {{1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

}  // namespace lume::geometry
