// SPDX-License-Identifier: Apache-2.0
// Sixteen rays side by side, and when rays are alike enough for that.
#pragma once

#include "geometry/accelerators/wide/rays.h"

#include <cmath>

namespace lume::geometry::wide {

[[gnu::always_inline]] inline float least_of(const float (&values)[k_packet_size]) {
  float four[4] = {values[0], values[1], values[2], values[3]};
  for (unsigned i = 4; i < k_packet_size; ++i) {
    four[i % 4] = values[i] < four[i % 4] ? values[i] : four[i % 4];
  }
  const float a = four[0] < four[1] ? four[0] : four[1];
  const float b = four[2] < four[3] ? four[2] : four[3];
  return a < b ? a : b;
}
[[gnu::always_inline]] inline float most_of(const float (&values)[k_packet_size]) {
  float four[4] = {values[0], values[1], values[2], values[3]};
  for (unsigned i = 4; i < k_packet_size; ++i) {
    four[i % 4] = values[i] > four[i % 4] ? values[i] : four[i % 4];
  }
  const float a = four[0] > four[1] ? four[0] : four[1];
  const float b = four[2] > four[3] ? four[2] : four[3];
  return a > b ? a : b;
}

/// Up to sixteen rays of one octant and one longest axis, side by side.
template <class Simd>
struct Packet {
  using Float8 = typename Simd::Float8;

  alignas(64) float inverse[3][k_packet_size];
  alignas(64) float near_offset[3][k_packet_size];
  alignas(64) float far_offset[3][k_packet_size];
  alignas(64) float t_min[k_packet_size];
  alignas(64) float t_max[k_packet_size];  ///< -1 for those that are not there
  double scale[k_packet_size];

  /// Of the triangles' test.
  alignas(64) double origin[3][k_packet_size];
  alignas(64) double shear_x[k_packet_size];
  alignas(64) double shear_y[k_packet_size];
  alignas(64) double length_z[k_packet_size];
  unsigned axis[3];  ///< x, y and z of ShearRay

  /// What holds for all rays.
  Float8 least_inverse[3];
  Float8 most_inverse[3];
  Float8 least_near[3];
  Float8 most_far[3];
  float first;  ///< least t_min
  unsigned near_row[3];

  [[gnu::always_inline]] void set_t_max(unsigned ray, double t) {
    t_max[ray] = static_cast<float>(t * scale[ray] * (1.0 + 0x1p-22));
  }
  /// One ray, for tests against four triangles.
  [[nodiscard, gnu::always_inline]] ShearRay alone(unsigned ray) const {
    ShearRay result;
    for (unsigned i = 0; i < 3; ++i) result.origin[i] = origin[i][ray];
    result.x = axis[0];
    result.y = axis[1];
    result.z = axis[2];
    result.shear_x = shear_x[ray];
    result.shear_y = shear_y[ray];
    result.length_z = length_z[ray];
    return result;
  }
  [[nodiscard, gnu::always_inline]] float last() const { return most_of(t_max); }
};

/// The octant of a ray, and its longest axis as in ShearRay.
[[gnu::always_inline]] inline unsigned kind_of(const TreeRay& ray) {
  const double* d = ray.direction;
  const double x = std::fabs(d[0]);
  const double y = std::fabs(d[1]);
  const double z = std::fabs(d[2]);
  const unsigned longest = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
  return longest << 3u | (std::signbit(d[0]) ? 4u : 0u) | (std::signbit(d[1]) ? 2u : 0u) |
         (std::signbit(d[2]) ? 1u : 0u);
}

/// Whether rays of these queries can be one packet.
[[gnu::always_inline]] inline bool run_alike(const TriangleQuery* queries, unsigned count) {
  const unsigned kind = kind_of(queries[0].ray);
  bool alike = count > 1;
  for (unsigned i = 1; i < count; ++i) alike &= kind_of(queries[i].ray) == kind;
  return alike;
}

/// What Simd::prepare() and ShearRay do for one ray, in loops over all that compilers turn into
/// SIMD.
template <class Simd>
[[gnu::always_inline]] inline void fill_packet(const Tree& tree, const TriangleQuery* queries,
                                               unsigned count, Packet<Simd>& packet) {
  alignas(64) double direction[3][k_packet_size];
  alignas(64) double t_min[k_packet_size];
  alignas(64) double t_max[k_packet_size];
  for (unsigned i = 0; i < k_packet_size; ++i) {
    const TreeRay& ray = queries[i < count ? i : 0].ray;
    for (unsigned axis = 0; axis < 3; ++axis) {
      direction[axis][i] = ray.direction[axis];
      packet.origin[axis][i] = ray.origin[axis];
    }
    t_min[i] = ray.t_min;
    t_max[i] = ray.t_max;
  }
  const ShearRay shape(queries[0].ray);
  packet.axis[0] = shape.x;
  packet.axis[1] = shape.y;
  packet.axis[2] = shape.z;
  for (unsigned i = 0; i < k_packet_size; ++i) {
    packet.length_z[i] = direction[shape.z][i];
    packet.shear_x[i] = direction[shape.x][i] / direction[shape.z][i];
    packet.shear_y[i] = direction[shape.y][i] / direction[shape.z][i];
    packet.scale[i] = std::fabs(direction[shape.z][i]);
    packet.t_min[i] = static_cast<float>(t_min[i] * packet.scale[i] * (1.0 - 0x1p-22));
    packet.t_max[i] = static_cast<float>(t_max[i] * packet.scale[i] * (1.0 + 0x1p-22));
  }
  for (unsigned axis = 0; axis < 3; ++axis) {
    const auto farthest = static_cast<double>(tree.farthest[axis]);
    for (unsigned i = 0; i < k_packet_size; ++i) {
      const double d = direction[axis][i] / packet.scale[i];
      const double size = std::fabs(d);
      const double steep = size > Reciprocal::k_flattest ? size : Reciprocal::k_flattest;
      const double inverse = 1.0 / std::copysign(steep, d);
      const double slack = Reciprocal::k_rounding * (std::fabs(packet.origin[axis][i]) + farthest) *
                           std::fabs(inverse);
      const double offset = -packet.origin[axis][i] * inverse;
      packet.inverse[axis][i] = static_cast<float>(inverse);
      packet.near_offset[axis][i] = static_cast<float>(offset - slack);
      packet.far_offset[axis][i] = static_cast<float>(offset + slack);
    }
    packet.least_inverse[axis] = Simd::fill(least_of(packet.inverse[axis]));
    packet.most_inverse[axis] = Simd::fill(most_of(packet.inverse[axis]));
    packet.least_near[axis] = Simd::fill(least_of(packet.near_offset[axis]));
    packet.most_far[axis] = Simd::fill(most_of(packet.far_offset[axis]));
    packet.near_row[axis] = 2 * axis + (std::signbit(direction[axis][0]) ? 1 : 0);
  }
  for (unsigned i = count; i < k_packet_size; ++i) packet.t_max[i] = -1.0f;
  packet.first = least_of(packet.t_min);
}

}  // namespace lume::geometry::wide
