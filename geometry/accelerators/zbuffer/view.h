// SPDX-License-Identifier: Apache-2.0
// The camera's picture as a raster of cells, a pixel each, and a border around it: which cell a ray
// goes through, and where points are seen.
#pragma once

#include "geometry/bounds.h"
#include "geometry/camera.h"
#include "geometry/ray.h"

#include <optional>

namespace lume::geometry::zbuffer {

/// A rectangle of the picture, in cells.
using Rect = BoundsOf<glm::dvec2>;

/// Where a ray runs in the picture.
struct ViewRay {
  int column = 0;
  int row = 0;
  double depth_at_start = 0.0;
  double depth_per_t = 1.0;

  [[nodiscard]] double depth(double t) const { return depth_at_start + t * depth_per_t; }
};

class View {
 public:
  /// Filters take samples from beyond the picture's edge, but hardly from farther away.
  static constexpr int k_border = 4;

  /// The camera is a pinhole one; width and height are above 0.
  View(const Camera& camera, int width, int height);

  /// Cells, the border included. Column 0 is on the left, row 0 at the top.
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] Rect all() const { return {glm::dvec2(0.0), glm::dvec2(columns_, rows_)}; }

  [[nodiscard]] bool is_perspective() const { return is_perspective_; }
  [[nodiscard]] const DVec3& eye() const { return eye_; }

  /// Of a way from the eye, in cells and metres: (x, y, depth) by an orthographic camera, by a
  /// perspective one (x depth, y depth, depth), so that it is a linear map for both but for offset().
  [[nodiscard]] const DMat3& to_cells() const { return to_cells_; }
  [[nodiscard]] const DVec3& offset() const { return offset_; }

  /// Rays begin at depths between -start_depth() and start_depth(), because floats are rounded.
  [[nodiscard]] double start_depth() const { return start_depth_; }

  /// Of a ray that the camera may have sent; none if it is any other one, or beyond the border.
  [[nodiscard]] std::optional<ViewRay> find(const Ray& ray) const;

 private:
  [[nodiscard]] bool is_ours(const Ray& ray) const;

  bool is_perspective_;
  Vec3 position_;
  Vec3 forward_;
  DVec3 eye_;
  int columns_;
  int rows_;
  DMat3 to_cells_{1.0};
  DVec3 offset_{0.0};
  double start_depth_ = 0.0;
};

}  // namespace lume::geometry::zbuffer
