// SPDX-License-Identifier: Apache-2.0
// "Which primitive does this ray meet first?" Every structure answers behind this interface, chosen
// by name at run time; the call is virtual once for each query and never inside a traversal.
#pragma once

#include "geometry/hit.h"
#include "geometry/hole_test.h"
#include "geometry/ray.h"
#include "geometry/world.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace lume::geometry {

struct AcceleratorStats {
  /// Counts what is in the world; the rest is the accelerator's to fill in.
  explicit AcceleratorStats(const World& world);

  double build_seconds = 0.0;
  std::size_t memory_bytes = 0;
  std::size_t primitives = 0;  ///< in all objects, each counted once
  std::size_t instances = 0;
};

class Accelerator {
 public:
  Accelerator() = default;
  Accelerator(const Accelerator&) = delete;
  Accelerator& operator=(const Accelerator&) = delete;
  virtual ~Accelerator() = default;

  /// The first primitive along the ray within [t_min, t_max] that is not a hole there.
  /// A ray that is not is_traceable meets nothing.
  [[nodiscard]] virtual std::optional<Hit> closest_hit(const Ray& ray) const = 0;
  /// Whether anything at all lies along the ray within [t_min, t_max].
  [[nodiscard]] virtual bool any_hit(const Ray& ray) const = 0;
  [[nodiscard]] virtual AcceleratorStats stats() const = 0;
};

/// The names that make_accelerator knows, default first.
[[nodiscard]] std::span<const std::string_view> accelerator_names();

/// Builds a structure over `world`, which must outlive it, as must `holes` (may be null when no
/// geometry has holes). Throws std::invalid_argument for an unknown name and std::runtime_error
/// when the structure cannot be built (out of memory).
[[nodiscard]] std::unique_ptr<Accelerator> make_accelerator(std::string_view name,
                                                            const World& world,
                                                            const HoleTest* holes);

}  // namespace lume::geometry
