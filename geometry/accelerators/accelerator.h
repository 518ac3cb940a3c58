// SPDX-License-Identifier: Apache-2.0
// "Which primitive does this ray meet first?" Every structure answers behind this interface, chosen
// by name at run time; the call is virtual once for each query and never inside a traversal.
#pragma once

#include "geometry/accelerators/traversal_cost.h"
#include "geometry/camera.h"
#include "geometry/hit.h"
#include "geometry/hole_test.h"
#include "geometry/ray.h"
#include "geometry/world.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lume::geometry {

/// What a structure is made of; 0 where it does not say.
struct AcceleratorStats {
  /// Counts what is in the world; the rest is the accelerator's to fill in.
  explicit AcceleratorStats(const World& world);

  double build_seconds = 0.0;
  std::size_t memory_bytes = 0;  ///< held by the structure itself, the world's meshes not counted
  std::size_t primitives = 0;    ///< in all objects, each counted once
  std::size_t instances = 0;
  StructureStats structure;
};

class Accelerator {
 public:
  Accelerator() = default;
  Accelerator(const Accelerator&) = delete;
  Accelerator& operator=(const Accelerator&) = delete;
  virtual ~Accelerator() = default;

  /// The first primitive along the ray within [t_min, t_max] that is not a hole there; of several
  /// at the same t the one of lowest identity. A ray that is not is_traceable meets nothing.
  [[nodiscard]] virtual std::optional<Hit> closest_hit(const Ray& ray) const = 0;
  /// Whether anything at all lies along the ray within [t_min, t_max].
  [[nodiscard]] virtual bool any_hit(const Ray& ray) const = 0;

  /// The same for rays that run much alike (a tile of camera rays, the shadow rays of one lamp),
  /// which some structures follow together. The spans are of one length.
  virtual void closest_hits(std::span<const Ray> rays, std::span<std::optional<Hit>> hits) const;
  virtual void any_hits(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const;

  /// Whether the next two say what they did.
  [[nodiscard]] virtual bool counts_cost() const { return false; }
  /// The same answers; what the query did is added to `cost`.
  [[nodiscard]] virtual std::optional<Hit> closest_hit_counted(const Ray& ray,
                                                               TraversalCost& cost) const;
  [[nodiscard]] virtual bool any_hit_counted(const Ray& ray, TraversalCost& cost) const;

  /// Says whose camera's rays are to come, in an image of that many pixels. Only structures in the
  /// order of objects (the z-buffer) have a use for it; any ray may be asked all the same.
  virtual void prepare_view(const Camera& camera, int width, int height);

  [[nodiscard]] virtual AcceleratorStats stats() const = 0;
};

struct AcceleratorOptions {
  /// Of a library's structure: let it decide by itself, in float, which of two triangles is nearer
  /// and whether an edge is met. That is how its own users see it, and a little faster; pictures
  /// then differ in a few samples of a million.
  bool native_hits = false;
};

/// The names that make_accelerator knows, default first.
[[nodiscard]] std::span<const std::string_view> accelerator_names();

/// Builds a structure over `world`, which must outlive it, as must `holes` (may be null when no
/// geometry has holes). A name with a slash is the file of a plugin. Throws std::invalid_argument
/// for an unknown name and std::runtime_error when the structure cannot be built (out of memory, a
/// plugin that fails).
[[nodiscard]] std::unique_ptr<Accelerator> make_accelerator(std::string_view name,
                                                            const World& world,
                                                            const HoleTest* holes,
                                                            const AcceleratorOptions& options = {});

}  // namespace lume::geometry
