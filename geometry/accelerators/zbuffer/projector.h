// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/accelerators/zbuffer/footprint.h"
#include "geometry/transform.h"

#include <array>
#include <optional>
#include <span>

namespace lume::geometry::zbuffer {

/// Finds the footprints of what is in the space of one instance. The ways from the eye to points
/// are taken there, as a ray's test does, so that what is far from the world's origin loses
/// nothing.
class Projector {
 public:
  Projector(const View& view, const Transform& transform);

  /// None if it is behind the camera.
  [[nodiscard]] std::optional<Footprint> triangle(const std::array<Vec3, 3>& corners,
                                                  bool has_holes) const;
  /// Of whatever is in the box.
  [[nodiscard]] std::optional<Footprint> box(const Bounds& bounds) const;

 private:
  /// A point as the camera sees it.
  struct Sight {
    DVec3 place{0.0};    ///< as View::to_image says
    double size = 0.0;   ///< at least as long as `place`
    double error = 0.0;  ///< of its components
  };
  /// From one corner of a triangle to another.
  struct Side {
    DVec3 way{0.0};
    double size = 0.0;  ///< at least as long as `way`
  };
  using Corners = std::array<Sight, 3>;
  using Sides = std::array<Side, 3>;  ///< opposite corner i: from i + 1 to i + 2

  [[nodiscard]] Sight see(const Vec3& point) const;
  [[nodiscard]] Side side(const Vec3& from, const Vec3& to) const;
  [[nodiscard]] std::optional<Footprint> frame(std::span<const Sight> points) const;
  void add_cone(const Corners& corners, const Sides& sides, Footprint& result) const;
  void add_prism(const Corners& corners, const Sides& sides, Footprint& result) const;

  const View& view_;
  DVec3 eye_;
  DMat3 to_image_;
  double rounding_ = 0.0;  ///< relative, of a step of any computation with points
  double scale_ = 0.0;     ///< by how much to_image_ makes vectors longer, at most
  double far_ = 0.0;       ///< size of what is subtracted to find where a ray begins
  double reach_ = 0.0;     ///< size of the largest (x, y, 1) in the picture
};

}  // namespace lume::geometry::zbuffer
