// SPDX-License-Identifier: Apache-2.0
// A ray as the kernels need it: one form for boxes, one for triangles.
#pragma once

#include "geometry/accelerators/wide/query.h"

#include <cmath>

namespace lume::geometry::wide {

/// What a ray's direction and origin become, as Simd::prepare() computes it.
struct alignas(16) Reciprocal {
  /// Directions that are flatter count as this flat, so that no product is not a number.
  static constexpr double k_flattest = 1e-18;
  /// 1 / d, o / d, a product and a sum are rounded, each by 2^-24 of (|plane| + |o|) / |d| at most.
  static constexpr double k_rounding = 0x1p-22;

  float inverse[4];
  float near_offset[4];
  float far_offset[4];
  double scale;
};

/// A ray made ready for the boxes of a tree: t = plane / d - o / d in one fused multiply-add, where
/// o / d is moved by what may be rounded anywhere on the way, for the far planes up, for the near
/// ones down (Ize 2013, "Robust BVH Ray Traversal", JCGT 2(2), widens each interval instead). Along
/// its longest axis the direction has length 1 here, so that nothing overflows.
template <class Simd>
struct BoxRay {
  using Float8 = typename Simd::Float8;

  [[gnu::always_inline]] BoxRay(const TreeRay& ray, const float (&farthest)[4]) {
    Reciprocal reciprocal;
    Simd::prepare(ray, farthest, reciprocal);
    for (unsigned axis = 0; axis < 3; ++axis) {
      inverse[axis] = Simd::fill(reciprocal.inverse[axis]);
      near_offset[axis] = Simd::fill(reciprocal.near_offset[axis]);
      far_offset[axis] = Simd::fill(reciprocal.far_offset[axis]);
      near_row[axis] = 2 * axis + (std::signbit(ray.direction[axis]) ? 1 : 0);
    }
    scale = reciprocal.scale;
    t_min = Simd::fill(static_cast<float>(ray.t_min * scale * (1.0 - 0x1p-22)));
    set_t_max(ray.t_max);
  }

  [[gnu::always_inline]] void set_t_max(double t) {
    last = static_cast<float>(t * scale * (1.0 + 0x1p-22));
    t_max = Simd::fill(last);
  }

  /// A mask of the children whose boxes the ray meets, and where it enters each.
  [[gnu::always_inline]] unsigned enter(const Node& node, float (&entries)[k_width]) const {
    const auto near = [&](unsigned axis) {
      return Simd::fma(Simd::load(node.planes[near_row[axis]]), inverse[axis], near_offset[axis]);
    };
    const auto far = [&](unsigned axis) {
      return Simd::fma(Simd::load(node.planes[near_row[axis] ^ 1u]), inverse[axis],
                       far_offset[axis]);
    };
    const Float8 first = Simd::max(Simd::max(near(0), near(1)), Simd::max(near(2), t_min));
    const Float8 second = Simd::min(Simd::min(far(0), far(1)), Simd::min(far(2), t_max));
    Simd::store(entries, first);
    return Simd::not_above(first, second);
  }

  Float8 inverse[3];
  Float8 near_offset[3];
  Float8 far_offset[3];
  Float8 t_min;
  Float8 t_max;
  unsigned near_row[3];  ///< of Node::planes; its neighbour is the far one
  float last;            ///< t_max, once
  double scale;          ///< from the ray's t to the t here
};

/// A ray made ready for triangles: ShearedRay of shapes/triangle.h in plain numbers.
struct ShearRay {
  double origin[3];
  unsigned x;
  unsigned y;
  unsigned z;
  double shear_x;
  double shear_y;
  double length_z;

  ShearRay() = default;
  [[gnu::always_inline]] explicit ShearRay(const TreeRay& ray)
      : origin{ray.origin[0], ray.origin[1], ray.origin[2]} {
    const double* d = ray.direction;
    const double dx = std::fabs(d[0]);
    const double dy = std::fabs(d[1]);
    const double dz = std::fabs(d[2]);
    if (dx > dy) {
      z = dx > dz ? 0 : 2;
    } else {
      z = dy > dz ? 1 : 2;
    }
    x = (z + 1) % 3;
    y = (x + 1) % 3;
    if (d[z] < 0.0) {
      const unsigned other = x;
      x = y;
      y = other;
    }
    shear_x = d[x] / d[z];
    shear_y = d[y] / d[z];
    length_z = d[z];
  }
};

}  // namespace lume::geometry::wide
