// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bounds.h"
#include "geometry/ray.h"

#include <string>

namespace lume::geometry {

/// A perspective or orthographic camera in the scene's frame, looking along its -z with +y up, as
/// in glTF, through a pinhole or a thin lens. Clip planes are not kept: a ray tracer has no use for
/// them.
struct Camera {
  enum class Projection { perspective, orthographic };

  std::string name;
  Projection projection = Projection::perspective;
  Vec3 position{0.0f};
  Vec3 right{1.0f, 0.0f, 0.0f};  ///< right, up and backward are an orthonormal frame
  Vec3 up{0.0f, 1.0f, 0.0f};
  Vec3 backward{0.0f, 0.0f, 1.0f};
  float vertical_fov = 0.8f;  ///< radians, perspective only
  float half_height = 1.0f;   ///< metres, orthographic only
  float aspect = 0.0f;        ///< width / height the camera was made for; 0: any
  float lens_radius = 0.0f;   ///< metres; 0: a pinhole, all is sharp
  /// Metres along the viewing axis to the plane that is sharp, above 0; may be infinite.
  float focus_distance = 1.0f;

  /// The ray through image-plane position `ndc` (x to the right, y down, both 0..1 over the whole
  /// image) for an image of the given width / height. The direction is a unit vector. `lens`, two
  /// numbers in [0, 1), chooses the point of the lens that the ray comes from, uniformly by area:
  /// all rays of one image position meet in one point of the plane that is sharp (Cook, Porter and
  /// Carpenter 1984, "Distributed Ray Tracing", section 4.2).
  [[nodiscard]] Ray generate_ray(Vec2 ndc, float image_aspect, Vec2 lens = Vec2(0.5f)) const;

  /// Distance of a point along the viewing axis (metres; positive in front).
  [[nodiscard]] float depth(const Vec3& point) const { return dot(position - point, backward); }
};

/// A perspective camera at `eye` that looks at `target`; +y is up unless it is the viewing axis.
[[nodiscard]] Camera look_at(const Vec3& eye, const Vec3& target, float vertical_fov);

/// eye = target + radius (sin phi sin theta, cos phi, sin phi cos theta), angles in radians:
/// theta 0, phi pi/2 stands on +z and looks along -z.
[[nodiscard]] Camera orbit(const Vec3& target, float theta, float phi, float radius,
                           float vertical_fov);

/// A camera from the front, a little to the right and above, in whose image of the given
/// width / height the whole box is to be seen.
[[nodiscard]] Camera frame_bounds(const Bounds& bounds, float image_aspect);

}  // namespace lume::geometry
