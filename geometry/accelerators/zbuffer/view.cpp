// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/zbuffer/view.h"

#include <cmath>

namespace lume::geometry::zbuffer {

View::View(const Camera& camera, int width, int height)
    : is_perspective_(camera.projection == Camera::Projection::perspective),
      position_(camera.position),
      forward_(-camera.backward),
      eye_(camera.position),
      size_(width + 2 * k_border, height + 2 * k_border),
      cells_per_unit_(0.5 * height) {
  // What floats leave of an orthonormal frame is inverted, not transposed: all points of a ray must
  // come to the same place.
  to_image_ = glm::inverse(DMat3(DVec3(camera.right), DVec3(camera.up), DVec3(forward_)));
  DVec3 scale(1.0);
  if (is_perspective_) {
    const double per_unit = 1.0 / std::tan(0.5 * static_cast<double>(camera.vertical_fov));
    scale = {per_unit, -per_unit, 1.0};
  } else {
    const double per_unit = 1.0 / static_cast<double>(camera.half_height);
    scale = {per_unit, -per_unit, per_unit};
    const double aspect = static_cast<double>(width) / height;
    constexpr double k_rounding = 1e-5;  // of what generate_ray adds up; more than enough
    start_depth_ = k_rounding * (length(eye_) * per_unit + 2.0 + aspect);
  }
  for (int column = 0; column < 3; ++column) to_image_[column] *= scale;
}

Rect View::rect(const CellRange& cells) const {
  const glm::dvec2 middle = 0.5 * glm::dvec2(size_);
  constexpr double k_wider = 1e-6;  // of a cell; far more than is rounded in find()
  return {(glm::dvec2(cells.first) - k_wider - middle) / cells_per_unit_,
          (glm::dvec2(cells.last) + k_wider - middle) / cells_per_unit_};
}

CellRange View::touched_by(const Rect& rect) const {
  const glm::dvec2 middle = 0.5 * glm::dvec2(size_);
  constexpr double k_wider = 0.01;
  // Cut to the picture while they are doubles, which have room for every place.
  const glm::dvec2 lower = rect.lower * cells_per_unit_ + middle - k_wider;
  const glm::dvec2 upper = rect.upper * cells_per_unit_ + middle + k_wider;
  const glm::dvec2 end(size_);
  return {glm::ivec2(glm::clamp(glm::floor(lower), glm::dvec2(0.0), end)),
          glm::ivec2(glm::clamp(glm::floor(upper) + 1.0, glm::dvec2(0.0), end))};
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
    place = to_image_ * DVec3(ray.direction);
    if (!(place.z > 0.0)) return std::nullopt;
    result.depth_per_t = place.z;
    place /= place.z;
  } else {
    place = to_image_ * (DVec3(ray.origin) - eye_);
    if (!(std::abs(place.z) <= start_depth_)) return std::nullopt;
    result.start_depth = place.z;
    result.depth_per_t = (to_image_ * DVec3(ray.direction)).z;
  }
  const glm::dvec2 cell = glm::dvec2(place) * cells_per_unit_ + 0.5 * glm::dvec2(size_);
  const bool is_inside = cell.x >= 0.0 && cell.x < size_.x && cell.y >= 0.0 && cell.y < size_.y;
  if (!is_inside) return std::nullopt;
  result.cell = glm::ivec2(cell);
  return result;
}

}  // namespace lume::geometry::zbuffer
