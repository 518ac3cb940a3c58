// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/zbuffer/view.h"

#include <cmath>

namespace lume::geometry::zbuffer {

View::View(const Camera& camera, int width, int height)
    : is_perspective_(camera.projection == Camera::Projection::perspective),
      position_(camera.position),
      forward_(-camera.backward),
      eye_(camera.position),
      columns_(width + 2 * k_border),
      rows_(height + 2 * k_border) {
  // What floats leave of an orthonormal frame is inverted, not transposed: all points of a ray must
  // come to the same place.
  const DMat3 to_frame =
      glm::inverse(DMat3(DVec3(camera.right), DVec3(camera.up), DVec3(forward_)));
  const double half = is_perspective_ ? std::tan(0.5 * static_cast<double>(camera.vertical_fov))
                                      : static_cast<double>(camera.half_height);
  const double cells = 0.5 * height / half;  // a pixel is as wide as it is high
  const DVec3 middle(0.5 * columns_, 0.5 * rows_, 0.0);
  DMat3 to_raster(1.0);
  to_raster[0] = {cells, 0.0, 0.0};
  to_raster[1] = {0.0, -cells, 0.0};
  if (is_perspective_) {
    to_raster[2] = {middle.x, middle.y, 1.0};
  } else {
    offset_ = middle;
    constexpr double k_float_rounding = 1e-5;  // of what generate_ray adds up, and more than enough
    start_depth_ = k_float_rounding * (length(eye_) + half * (2.0 + static_cast<double>(width) / height));
  }
  to_cells_ = to_raster * to_frame;
}

bool View::is_ours(const Ray& ray) const {
  return ray.t_min == 0.0f &&
         (is_perspective_ ? ray.origin == position_ : ray.direction == forward_);
}

std::optional<ViewRay> View::find(const Ray& ray) const {
  if (!is_ours(ray)) return std::nullopt;
  ViewRay result;
  DVec3 place(0.0);
  if (is_perspective_) {
    place = to_cells_ * DVec3(ray.direction);
    if (!(place.z > 0.0)) return std::nullopt;
    result.depth_per_t = place.z;
    place /= place.z;
  } else {
    place = to_cells_ * (DVec3(ray.origin) - eye_) + offset_;
    if (!(std::abs(place.z) <= start_depth_)) return std::nullopt;
    result.depth_at_start = place.z;
  }
  if (!(place.x >= 0.0 && place.x < columns_ && place.y >= 0.0 && place.y < rows_)) {
    return std::nullopt;
  }
  result.column = static_cast<int>(place.x);
  result.row = static_cast<int>(place.y);
  return result;
}

}  // namespace lume::geometry::zbuffer
