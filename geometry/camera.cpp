// SPDX-License-Identifier: Apache-2.0
#include "geometry/camera.h"

#include "geometry/disk.h"

#include <algorithm>
#include <cmath>

namespace lume::geometry {

Ray Camera::generate_ray(Vec2 ndc, float image_aspect, Vec2 lens) const {
  const float x = (2.0f * ndc.x - 1.0f) * image_aspect;
  const float y = 1.0f - 2.0f * ndc.y;
  Ray ray;
  Vec3 forward;  // how far the ray through the lens's centre gets in one metre of depth
  if (projection == Projection::orthographic) {
    ray.origin = position + half_height * (x * right + y * up);
    forward = -backward;
    ray.direction = forward;
  } else {
    const float half = std::tan(0.5f * vertical_fov);  // of the image plane at distance 1
    ray.origin = position;
    forward = half * (x * right + y * up) - backward;
    ray.direction = normalize(forward);
  }
  if (lens_radius > 0.0f) {
    const Vec2 on_lens = lens_radius * concentric_disk(lens);
    const Vec3 aside = on_lens.x * right + on_lens.y * up;
    ray.origin += aside;
    ray.direction = normalize(forward - aside / focus_distance);  // back again where it is sharp
  }
  return ray;
}

Camera look_at(const Vec3& eye, const Vec3& target, float vertical_fov) {
  Camera camera;
  camera.position = eye;
  camera.vertical_fov = vertical_fov;
  const Vec3 away = eye - target;
  camera.backward = length(away) > 0.0f ? normalize(away) : Vec3(0.0f, 0.0f, 1.0f);
  // Looking straight up or down, "up" is where a camera that tilted there from the front has it.
  const bool along_y = std::abs(camera.backward.y) > 0.999999f;
  const Vec3 up =
      along_y ? Vec3(0.0f, 0.0f, camera.backward.y > 0.0f ? -1.0f : 1.0f) : Vec3(0.0f, 1.0f, 0.0f);
  camera.right = normalize(cross(up, camera.backward));
  camera.up = cross(camera.backward, camera.right);
  return camera;
}

Camera orbit(const Vec3& target, float theta, float phi, float radius, float vertical_fov) {
  const Vec3 outward(std::sin(phi) * std::sin(theta), std::cos(phi),
                     std::sin(phi) * std::cos(theta));
  Camera camera = look_at(target + radius * outward, target, vertical_fov);
  // The angles also say which way is up at the poles, where the eye alone does not: right is the
  // horizontal direction of growing theta.
  camera.backward = normalize(outward);
  camera.right = {std::cos(theta), 0.0f, -std::sin(theta)};
  camera.up = cross(camera.backward, camera.right);
  return camera;
}

Camera frame_bounds(const Bounds& bounds, float image_aspect) {
  constexpr float k_fov = 0.6f;                           // radians: a mild telephoto, 34 degrees
  constexpr float k_margin = 1.05f;                       // of empty space around the object
  const Vec3 from = normalize(Vec3(0.45f, 0.35f, 1.0f));  // front, a little right and above
  const Vec3 center = bounds.is_empty() ? Vec3(0.0f) : bounds.center();
  Camera camera = look_at(center + from, center, k_fov);
  // The eye goes back along `backward` until every corner is inside the four side planes.
  const float half_y = std::tan(0.5f * k_fov) / k_margin;
  const float half_x = half_y * image_aspect;
  const Vec3 half_size = 0.5f * bounds.size();
  float distance = 1e-3f;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p =
        half_size * Vec3((corner & 1) != 0 ? 1.0f : -1.0f, (corner & 2) != 0 ? 1.0f : -1.0f,
                         (corner & 4) != 0 ? 1.0f : -1.0f);
    const float towards_eye = dot(p, camera.backward);
    distance = std::max({distance, towards_eye + std::abs(dot(p, camera.right)) / half_x,
                         towards_eye + std::abs(dot(p, camera.up)) / half_y});
  }
  camera.position = center + distance * camera.backward;
  return camera;
}

}  // namespace lume::geometry
