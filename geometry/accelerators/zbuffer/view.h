// SPDX-License-Identifier: Apache-2.0
// The camera's picture as a raster of cells, a pixel each, and a border around it: which cell a ray
// goes through, and where points are seen.
#pragma once

#include "geometry/bounds.h"
#include "geometry/camera.h"
#include "geometry/ray.h"

#include <optional>

namespace lume::geometry::zbuffer {

/// A rectangle of the picture: from its middle to the right and down, in halves of its height.
using Rect = BoundsOf<glm::dvec2>;

/// The cells from `first` up to, but not with, `last`; as (column, row).
struct CellRange {
  glm::ivec2 first{0};
  glm::ivec2 last{0};
};

/// Where a ray runs in the picture.
struct ViewRay {
  glm::ivec2 cell{0};
  double start_depth = 0.0;
  double depth_per_t = 1.0;

  [[nodiscard]] double depth(double t) const { return start_depth + t * depth_per_t; }
};

class View {
 public:
  /// Filters take samples from beyond the picture's edge, but hardly from farther away.
  static constexpr int k_border = 4;

  /// The camera is a pinhole one; width and height (pixels) are above 0.
  View(const Camera& camera, int width, int height);

  /// Columns and rows, the border included. Column 0 is on the left, row 0 at the top.
  [[nodiscard]] const glm::ivec2& size() const { return size_; }
  /// Around cells, and all rays that find() says go through them.
  [[nodiscard]] Rect rect(const CellRange& cells) const;
  /// The cells that touch a rectangle.
  [[nodiscard]] CellRange touched_by(const Rect& rect) const;

  [[nodiscard]] bool is_perspective() const { return is_perspective_; }
  [[nodiscard]] const DVec3& eye() const { return eye_; }

  /// Of a way from the eye: (x, y, depth) by an orthographic camera, all three in halves of the
  /// picture's height, and (x depth, y depth, depth) by a perspective one, the depth in metres. So
  /// it is a linear map for both.
  [[nodiscard]] const DMat3& to_image() const { return to_image_; }

  /// Rays begin between this depth and its negative, because floats are rounded.
  [[nodiscard]] double start_depth() const { return start_depth_; }

  /// Of a ray that the camera may have sent; none if it is any other one, or beyond the border.
  [[nodiscard]] std::optional<ViewRay> find(const Ray& ray) const;

 private:
  [[nodiscard]] bool is_ours(const Ray& ray) const;

  bool is_perspective_;
  Vec3 position_;
  Vec3 forward_;
  DVec3 eye_;
  glm::ivec2 size_;
  double cells_per_unit_;
  DMat3 to_image_{1.0};
  double start_depth_ = 0.0;
};

}  // namespace lume::geometry::zbuffer
