// SPDX-License-Identifier: Apache-2.0
// What a kernel is asked, and the table of what it can do. Kernels are compiled for instruction
// sets that this machine may not have, so nothing here brings code of its own along.
#pragma once

#include "geometry/accelerators/traversal_cost.h"
#include "geometry/accelerators/wide/wide_tree.h"

#include <cstddef>
#include <cstdint>

namespace lume::geometry::wide {

/// A ray in the space of a tree, finite and with a direction.
struct TreeRay {
  double origin[3];
  double direction[3];
  double t_min;
  double t_max;  ///< kernels lower it to what they find
};

/// Says whether a crossing is a hole; `u` and `v` are barycentric coordinates.
struct Holes {
  bool (*is_hole)(const void* context, std::uint32_t item, double u, double v) = nullptr;
  const void* context = nullptr;
};

/// A query of the lower level.
struct TriangleQuery {
  TreeRay ray;
  /// The nearest so far, which must be this tree's; of several at the same t the lowest.
  std::uint32_t item = k_no_item;
  /// A crossing at exactly ray.t_max counts only below this item.
  std::uint32_t item_limit = k_no_item;
  Holes holes;
  TraversalCost* cost = nullptr;  ///< null: nobody asks
};

/// A query of the upper level.
struct SceneQuery {
  TreeRay ray;
  /// Asks a placement; may lower ray.t_max. True ends the query.
  bool (*visit)(SceneQuery& query, std::uint32_t placement) = nullptr;
  void* context = nullptr;
  TraversalCost* cost = nullptr;
};

inline constexpr unsigned k_packet_size = 16;

/// The traversals, for one instruction set.
struct Kernel {
  const char* name;
  void (*closest)(const Tree& tree, TriangleQuery& query);
  bool (*any)(const Tree& tree, TriangleQuery& query);
  bool (*scene)(const Tree& tree, SceneQuery& query);
  /// For up to k_packet_size queries without holes or cost; a mask of those that meet anything.
  void (*closest_of_packet)(const Tree& tree, TriangleQuery* queries, unsigned count);
  unsigned (*any_of_packet)(const Tree& tree, TriangleQuery* queries, unsigned count);
};

extern const Kernel k_scalar_kernel;
extern const Kernel k_avx2_kernel;
extern const Kernel k_avx512_kernel;

[[nodiscard]] bool can_run(const Kernel& kernel);
/// The best that this processor can run; LUME_WIDE_KERNEL = scalar, avx2 or avx512 chooses another.
[[nodiscard]] const Kernel& best_kernel();

}  // namespace lume::geometry::wide
