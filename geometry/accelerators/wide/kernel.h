// SPDX-License-Identifier: Apache-2.0
// The traversals of the wide tree, written once over the handful of SIMD operations that a `Simd`
// type names (simd_scalar.h, simd_avx2.h, simd_avx512.h).
//
// Boxes are tested in float, so that none is missed that a ray in double meets; triangles in double
// by the very operations of intersect_triangle() (shapes/triangle.h), four at a time. So the
// kernels name the same triangle as brute force, on every processor.
#pragma once

#include "geometry/accelerators/wide/query.h"
#include "geometry/accelerators/wide/rays.h"

#include <bit>

namespace lume::geometry::wide {

/// The crossings of a ray with a block: a mask of the triangles that its line passes through, and
/// what it takes to say where.
template <class Simd>
struct BlockCrossing {
  using Double4 = typename Simd::Double4;

  [[gnu::always_inline]] BlockCrossing(const ShearRay& ray, const TriangleBlock& block) {
    const Double4 ox = Simd::set(ray.origin[ray.x]);
    const Double4 oy = Simd::set(ray.origin[ray.y]);
    const Double4 oz = Simd::set(ray.origin[ray.z]);
    const Double4 shear_x = Simd::set(ray.shear_x);
    const Double4 shear_y = Simd::set(ray.shear_y);
    Double4 x[3];
    Double4 y[3];
    for (unsigned i = 0; i < 3; ++i) {
      z[i] = Simd::sub(Simd::widen(block.corner[i][ray.z]), oz);
      x[i] =
          Simd::sub(Simd::sub(Simd::widen(block.corner[i][ray.x]), ox), Simd::mul(shear_x, z[i]));
      y[i] =
          Simd::sub(Simd::sub(Simd::widen(block.corner[i][ray.y]), oy), Simd::mul(shear_y, z[i]));
    }
    weight[0] = Simd::sub(Simd::mul(x[2], y[1]), Simd::mul(y[2], x[1]));
    weight[1] = Simd::sub(Simd::mul(x[0], y[2]), Simd::mul(y[0], x[2]));
    weight[2] = Simd::sub(Simd::mul(x[1], y[0]), Simd::mul(y[1], x[0]));
    sum = Simd::add(Simd::add(weight[0], weight[1]), weight[2]);
    mask = Simd::same_sign(weight[0], weight[1], weight[2]) & Simd::not_zero(sum);
  }

  /// Distances along the ray; of use where the mask says so.
  [[nodiscard, gnu::always_inline]] Double4 t(const ShearRay& ray) const {
    const Double4 weighted =
        Simd::add(Simd::add(Simd::mul(weight[0], z[0]), Simd::mul(weight[1], z[1])),
                  Simd::mul(weight[2], z[2]));
    return Simd::div(weighted, Simd::mul(sum, Simd::set(ray.length_z)));
  }

  /// Whether the crossing with triangle `lane` is a hole.
  [[nodiscard]] bool is_hole(const Holes& holes, std::uint32_t item, unsigned lane) const {
    alignas(32) double w1[4];
    alignas(32) double w2[4];
    alignas(32) double all[4];
    Simd::store(w1, weight[1]);
    Simd::store(w2, weight[2]);
    Simd::store(all, sum);
    return holes.is_hole(holes.context, item, w1[lane] / all[lane], w2[lane] / all[lane]);
  }

  Double4 weight[3];
  Double4 z[3];
  Double4 sum;
  unsigned mask;
};

/// The two bits that say what a traversal has to do beyond the plain search.
template <bool HasHoles, bool Counts>
struct Mode {
  static constexpr bool k_has_holes = HasHoles;
  static constexpr bool k_counts = Counts;
};

/// A child to be visited, and the t at which its box begins (in the upper half, so that entries
/// sort by it: floats that are not negative are in the order of their bits).
using StackEntry = std::uint64_t;

/// By addresses as numbers: a leaf of the scene's tree is a placement, and there may be no blocks.
[[gnu::always_inline]] inline void prefetch(const Tree& tree, std::uint32_t child) {
  const std::uintptr_t address = Child::is_leaf(child)
                                     ? reinterpret_cast<std::uintptr_t>(tree.blocks.data()) +
                                           Child::first(child) * sizeof(*tree.blocks.data())
                                     : reinterpret_cast<std::uintptr_t>(tree.nodes.data()) +
                                           child * sizeof(*tree.nodes.data());
  for (const std::uintptr_t line : {0, 64, 128, 192}) {
    __builtin_prefetch(reinterpret_cast<const void*>(address + line));
  }
}

[[gnu::always_inline]] inline StackEntry stack_entry(float t, std::uint32_t child) {
  return static_cast<StackEntry>(std::bit_cast<std::uint32_t>(t)) << 32u | child;
}
[[gnu::always_inline]] inline float entry_t(StackEntry entry) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(entry >> 32u));
}
[[gnu::always_inline]] inline std::uint32_t entry_child(StackEntry entry) {
  return static_cast<std::uint32_t>(entry);
}

/// Puts the children of a node that the ray meets on the stack, the nearest on top if they are to
/// be sorted, but returns the top itself. False if it meets none.
template <class Simd, bool Sorted>
[[gnu::always_inline]] inline bool descend(const Tree& tree, const Node& node,
                                           const BoxRay<Simd>& ray, StackEntry*& stack,
                                           std::uint32_t& child) {
  alignas(32) float enter[k_width];
  unsigned mask = ray.enter(node, enter);
  if (mask == 0) return false;
  const auto take_lane = [&mask] {
    const auto lane = static_cast<unsigned>(std::countr_zero(mask));
    mask &= mask - 1;
    return lane;
  };
  const auto entry = [&](unsigned lane) {
    prefetch(tree, node.child[lane]);
    return stack_entry(enter[lane], node.child[lane]);
  };
  const unsigned first = take_lane();
  child = node.child[first];
  if (mask == 0) return true;
  if constexpr (!Sorted) {
    while (mask != 0) *stack++ = entry(take_lane());
    return true;
  }
  const unsigned second = take_lane();
  if (mask == 0) {
    const bool in_order = enter[first] <= enter[second];
    *stack++ = entry(in_order ? second : first);
    child = node.child[in_order ? first : second];
    return true;
  }
  StackEntry* const bottom = stack;
  const auto insert = [&](StackEntry added) {
    StackEntry* place = stack++;
    for (; place > bottom && place[-1] < added; --place) *place = place[-1];
    *place = added;
  };
  insert(entry(first));
  insert(entry(second));
  while (mask != 0) insert(entry(take_lane()));
  child = entry_child(*--stack);
  return true;
}

/// Visits the leaves that the ray meets, nearest first if they are to be sorted; `visit(first,
/// count)` returns true to end the search, whose result it then is. visit may lower box_ray.t_max.
template <class Simd, bool Sorted, bool Counts, class Visit>
[[gnu::always_inline]] inline bool traverse(const Tree& tree, BoxRay<Simd>& box_ray,
                                            TraversalCost* cost, const Visit& visit) {
  if (tree.is_empty) return false;
  StackEntry stack_bottom[k_stack_size];
  StackEntry* stack = stack_bottom;
  std::uint32_t child = tree.root;
  while (true) {
    while (!Child::is_leaf(child)) {
      if constexpr (Counts) ++cost->nodes;
      if (!descend<Simd, Sorted>(tree, tree.nodes[child], box_ray, stack, child)) goto next;
    }
    if (visit(Child::first(child), Child::count(child))) return true;
  next:
    do {
      if (stack == stack_bottom) return false;
      --stack;
    } while (Sorted && entry_t(*stack) > box_ray.last);
    child = entry_child(*stack);
  }
}

/// Takes of a block's crossings the nearest.
template <class Simd, class Mode>
[[gnu::always_inline]] inline void take_nearest(const ShearRay& ray, const TriangleBlock& block,
                                                TriangleQuery& query, BoxRay<Simd>& box_ray) {
  const BlockCrossing<Simd> crossing(ray, block);
  if (crossing.mask == 0) return;
  alignas(32) double t[TriangleBlock::k_size];
  Simd::store(t, crossing.t(ray));
  for (unsigned mask = crossing.mask; mask != 0; mask &= mask - 1) {
    const auto lane = static_cast<unsigned>(std::countr_zero(mask));
    const std::uint32_t item = block.item[lane];
    const bool nearer =
        t[lane] < query.ray.t_max || (t[lane] == query.ray.t_max && item < query.item_limit);
    if (!nearer || !(t[lane] >= query.ray.t_min)) continue;
    if (Mode::k_has_holes && crossing.is_hole(query.holes, item, lane)) continue;
    query.item = query.item_limit = item;
    query.ray.t_max = t[lane];
    box_ray.set_t_max(t[lane]);
  }
}

/// Whether the ray crosses any triangle of a block.
template <class Simd, class Mode>
[[gnu::always_inline]] inline bool crosses(const ShearRay& ray, const TriangleBlock& block,
                                           const TriangleQuery& query) {
  const BlockCrossing<Simd> crossing(ray, block);
  if (crossing.mask == 0) return false;
  const unsigned mask =
      crossing.mask & Simd::between(crossing.t(ray), query.ray.t_min, query.ray.t_max);
  if (!Mode::k_has_holes) return mask != 0;
  for (unsigned rest = mask; rest != 0; rest &= rest - 1) {
    const auto lane = static_cast<unsigned>(std::countr_zero(rest));
    if (!crossing.is_hole(query.holes, block.item[lane], lane)) return true;
  }
  return false;
}

template <class Simd, class Mode>
void find_closest(const Tree& tree, TriangleQuery& query) {
  BoxRay<Simd> box_ray(query.ray, tree.farthest);
  const ShearRay ray(query.ray);
  for (std::size_t i = 0; i < tree.outliers.size(); ++i) {
    take_nearest<Simd, Mode>(ray, tree.outliers[i], query, box_ray);
  }
  traverse<Simd, true, Mode::k_counts>(
      tree, box_ray, query.cost, [&](std::uint32_t first, std::uint32_t count) {
        if constexpr (Mode::k_counts) query.cost->primitive_tests += count * TriangleBlock::k_size;
        for (std::uint32_t i = first; i < first + count; ++i) {
          take_nearest<Simd, Mode>(ray, tree.blocks[i], query, box_ray);
        }
        return false;
      });
}

template <class Simd, class Mode>
bool find_any(const Tree& tree, TriangleQuery& query) {
  BoxRay<Simd> box_ray(query.ray, tree.farthest);
  const ShearRay ray(query.ray);
  for (std::size_t i = 0; i < tree.outliers.size(); ++i) {
    if (crosses<Simd, Mode>(ray, tree.outliers[i], query)) return true;
  }
  return traverse<Simd, false, Mode::k_counts>(
      tree, box_ray, query.cost, [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t i = first; i < first + count; ++i) {
          if constexpr (Mode::k_counts) query.cost->primitive_tests += TriangleBlock::k_size;
          if (crosses<Simd, Mode>(ray, tree.blocks[i], query)) return true;
        }
        return false;
      });
}

template <class Simd, bool Counts>
bool visit_scene(const Tree& tree, SceneQuery& query) {
  BoxRay<Simd> box_ray(query.ray, tree.farthest);
  return traverse<Simd, true, Counts>(tree, box_ray, query.cost,
                                      [&](std::uint32_t first, std::uint32_t count) {
                                        for (std::uint32_t i = first; i < first + count; ++i) {
                                          if (query.visit(query, tree.entries[i])) return true;
                                        }
                                        box_ray.set_t_max(query.ray.t_max);
                                        return false;
                                      });
}

/// The table entries: the mode is chosen once a query.
template <class Simd>
struct KernelOf {
  static void closest(const Tree& tree, TriangleQuery& query) {
    if (query.cost != nullptr) {
      query.holes.is_hole != nullptr ? find_closest<Simd, Mode<true, true>>(tree, query)
                                     : find_closest<Simd, Mode<false, true>>(tree, query);
    } else {
      query.holes.is_hole != nullptr ? find_closest<Simd, Mode<true, false>>(tree, query)
                                     : find_closest<Simd, Mode<false, false>>(tree, query);
    }
  }
  static bool any(const Tree& tree, TriangleQuery& query) {
    if (query.cost != nullptr) {
      return query.holes.is_hole != nullptr ? find_any<Simd, Mode<true, true>>(tree, query)
                                            : find_any<Simd, Mode<false, true>>(tree, query);
    }
    return query.holes.is_hole != nullptr ? find_any<Simd, Mode<true, false>>(tree, query)
                                          : find_any<Simd, Mode<false, false>>(tree, query);
  }
  static bool scene(const Tree& tree, SceneQuery& query) {
    return query.cost != nullptr ? visit_scene<Simd, true>(tree, query)
                                 : visit_scene<Simd, false>(tree, query);
  }
};

}  // namespace lume::geometry::wide
