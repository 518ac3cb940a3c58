// SPDX-License-Identifier: Apache-2.0
// The light of scenes that bring none. It is neutral, so that materials keep their colours, and it
// has shapes with soft edges, so that metals have something to reflect. The camera stands at +z.
#include "shading/environment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace lume::shading {
namespace {

constexpr int k_width = 256;
constexpr int k_height = 128;

/// A soft-edged rectangle on the plane at distance 1 towards `center`.
struct Softbox {
  Vec3 center;       ///< direction, not normalized
  float half_width;  ///< tangent of the angle
  float half_height;
  float softness;  ///< width of the edge, as a tangent
  Color radiance;
};

/// 1 inside, 0 outside, smooth between.
float coverage(float distance, float half_size, float softness) {
  return 1.0f - glm::smoothstep(half_size - softness, half_size + softness, std::abs(distance));
}

Color light_of(const Softbox& box, const Vec3& direction) {
  const Vec3 forward = geometry::normalize(box.center);
  const float depth = dot(direction, forward);
  if (depth <= 0.0f) return Color(0.0f);
  const Vec3 right = geometry::normalize(cross(forward, Vec3(0.0f, 1.0f, 0.0f)));
  const Vec3 up = cross(right, forward);
  return box.radiance * coverage(dot(direction, right) / depth, box.half_width, box.softness) *
         coverage(dot(direction, up) / depth, box.half_height, box.softness);
}

/// An overcast sky is three times as bright at the zenith as at the horizon (Moon and Spencer
/// 1942); the floor gives back a part of it, less towards the feet.
Color room(float height) {
  const Color sky = Color(0.98f, 0.99f, 1.0f) * (0.26f * (1.0f + 2.0f * std::max(height, 0.0f)));
  const Color floor = Color(1.0f, 0.985f, 0.965f) * (0.22f + 0.09f * std::min(height, 0.0f));
  return glm::mix(floor, sky, glm::smoothstep(-0.12f, 0.08f, height));
}

Color studio_radiance(const Vec3& direction) {
  const Softbox window{{-0.75f, 0.80f, 0.70f}, 0.50f, 0.62f, 0.10f, Color(2.95f, 2.92f, 2.87f)};
  const Softbox fill{{1.0f, 0.25f, 0.35f}, 0.26f, 0.75f, 0.14f, Color(0.78f, 0.79f, 0.81f)};
  return room(direction.y) + light_of(window, direction) + light_of(fill, direction);
}

}  // namespace

Environment studio_environment() {
  std::vector<Color> pixels;
  pixels.reserve(static_cast<std::size_t>(k_width) * k_height);
  for (int row = 0; row < k_height; ++row) {
    const float latitude = geometry::k_pi * (0.5f - (static_cast<float>(row) + 0.5f) / k_height);
    for (int column = 0; column < k_width; ++column) {
      const float azimuth =
          2.0f * geometry::k_pi * ((static_cast<float>(column) + 0.5f) / k_width - 0.5f);
      pixels.push_back(studio_radiance({std::cos(latitude) * std::cos(azimuth), std::sin(latitude),
                                        std::cos(latitude) * std::sin(azimuth)}));
    }
  }
  Environment environment(k_width, k_height, std::move(pixels));
  environment.visible = false;
  return environment;
}

}  // namespace lume::shading
