// SPDX-License-Identifier: Apache-2.0
// What structures sort: things with boxes, known by number. On the lower level they are an object's
// triangles, on the upper one what stands in the scene; a structure need not know which.
#pragma once

#include "geometry/bounds.h"
#include "geometry/hit.h"
#include "geometry/world.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace lume::geometry {

class Items {
 public:
  Items() = default;
  Items(const Items&) = delete;
  Items& operator=(const Items&) = delete;
  virtual ~Items() = default;

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(bounds_.size()); }
  /// Around item i. Finite, and lower <= upper.
  [[nodiscard]] const Bounds& bounds(std::uint32_t i) const { return bounds_[i]; }
  /// Around all items; empty if there are none.
  [[nodiscard]] Bounds all_bounds() const;

  /// Around the part of item i that is in `box`; empty if there is none. The item's own bounds cut
  /// by the box unless more is known.
  [[nodiscard]] virtual Bounds clipped(std::uint32_t i, const Bounds& box) const;
  /// Appends points whose convex hull contains item i: the corners of its box unless better are
  /// known.
  virtual void add_points(std::uint32_t i, std::vector<Vec3>& points) const;

 protected:
  std::vector<Bounds> bounds_;
};

/// Instances that stand where their object is, of objects that stand nowhere else: their triangles
/// can be sorted together, whatever node of a file they come from.
[[nodiscard]] std::vector<std::uint32_t> unmoved_instances(const World& world);

/// Triangles in the order of their identity, in object space. Those that are not finite are left
/// out: no ray meets them.
class TriangleItems final : public Items {
 public:
  /// Of an object, as instance 0.
  explicit TriangleItems(const Object& object);
  /// Of instances that stand where their objects are.
  TriangleItems(const World& world, const std::vector<std::uint32_t>& instances);

  [[nodiscard]] Hit identity(std::uint32_t i) const { return identities_[i]; }
  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t i) const {
    return meshes_[i]->corners(identities_[i].primitive);
  }
  [[nodiscard]] Bounds clipped(std::uint32_t i, const Bounds& box) const override;
  void add_points(std::uint32_t i, std::vector<Vec3>& points) const override;

 private:
  void reserve(std::size_t count);
  void add(const Object& object, std::uint32_t instance);

  std::vector<Hit> identities_;
  std::vector<const Mesh*> meshes_;
};

/// What stands in the scene: the triangles of an instance together, or one of its shapes.
struct Placement {
  std::uint32_t instance = 0;
  std::optional<std::uint32_t> shape;  ///< index of its geometry; none: the instance's triangles
};

/// The placements that have an end within reason, with their bounds in the scene's frame.
class PlacementItems final : public Items {
 public:
  /// `of_triangles` is around the triangles of each object, empty where it has none.
  PlacementItems(const World& world, const std::vector<Bounds>& of_triangles);

  [[nodiscard]] const Placement& placement(std::uint32_t i) const { return placements_[i]; }
  /// What has no end, or one beyond all reason, and cannot be sorted: every ray asks them, one by
  /// one.
  [[nodiscard]] const std::vector<Placement>& endless() const { return endless_; }

 private:
  std::vector<Placement> placements_;
  std::vector<Placement> endless_;
};

}  // namespace lume::geometry
