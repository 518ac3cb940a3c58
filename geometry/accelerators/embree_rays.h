// SPDX-License-Identifier: Apache-2.0
// Rays as Embree takes them: one by one, and sixteen side by side.
#pragma once

#include "geometry/ray.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace lume::geometry {

inline RTCRay to_embree(const Ray& ray) {
  RTCRay result{};
  result.org_x = ray.origin.x;
  result.org_y = ray.origin.y;
  result.org_z = ray.origin.z;
  result.tnear = ray.t_min;
  result.dir_x = ray.direction.x;
  result.dir_y = ray.direction.y;
  result.dir_z = ray.direction.z;
  result.tfar = ray.t_max;
  result.mask = ~0u;  // a mask of 0 meets nothing
  return result;
}

constexpr std::size_t k_embree_packet = 16;

/// Lanes without a ray that can be traced are not valid.
inline void fill_packet(std::span<const Ray> rays, RTCRay16& packet,
                        int (&valid)[k_embree_packet]) {
  std::fill_n(valid, k_embree_packet, 0);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const RTCRay ray = to_embree(rays[i]);
    packet.org_x[i] = ray.org_x;
    packet.org_y[i] = ray.org_y;
    packet.org_z[i] = ray.org_z;
    packet.tnear[i] = ray.tnear;
    packet.dir_x[i] = ray.dir_x;
    packet.dir_y[i] = ray.dir_y;
    packet.dir_z[i] = ray.dir_z;
    packet.tfar[i] = ray.tfar;
    packet.mask[i] = ray.mask;
    valid[i] = is_traceable(rays[i]) ? -1 : 0;
  }
}

/// Whether the signs of all directions are the same.
[[nodiscard]] inline bool is_of_one_octant(std::span<const Ray> rays) {
  const auto octant = [](const Ray& ray) {
    return (std::signbit(ray.direction.x) ? 1 : 0) | (std::signbit(ray.direction.y) ? 2 : 0) |
           (std::signbit(ray.direction.z) ? 4 : 0);
  };
  return std::all_of(rays.begin(), rays.end(),
                     [&](const Ray& ray) { return octant(ray) == octant(rays.front()); });
}

}  // namespace lume::geometry
