// SPDX-License-Identifier: Apache-2.0
// Light from infinitely far away, by direction: an equirectangular image, or one colour.
#pragma once

#include "shading/color.h"
#include "shading/distribution.h"

#include <optional>
#include <vector>

namespace lume::shading {

/// A direction drawn from a distribution over the sphere.
struct DirectionSample {
  Vec3 direction{0.0f};  ///< unit, away from the scene
  float pdf = 0.0f;      ///< per steradian
};

class Environment {
 public:
  /// The same radiance from everywhere (nits).
  explicit Environment(const Color& radiance);
  /// An equirectangular map, row 0 at the top: u = 0.5 + atan2(z, x) / (2 pi), v = 0.5 - asin(y) /
  /// pi for a direction (x, y, z). `pixels` holds width * height radiances, each finite and not
  /// negative.
  Environment(int width, int height, std::vector<Color> pixels);

  /// Turns the environment counter-clockwise around +y (radians).
  void rotate(float angle);
  void scale(float intensity);

  /// Radiance that arrives from the unit direction (nits), bilinearly interpolated.
  [[nodiscard]] Color radiance(const Vec3& direction) const;
  /// Draws a direction in proportion to the radiance (nearly: it is constant over each texel).
  [[nodiscard]] DirectionSample sample(Vec2 random) const;
  /// The density with which sample() returns the unit direction, per steradian.
  [[nodiscard]] float pdf(const Vec3& direction) const;

  /// Drawn behind the scene; otherwise it lights the scene but the backdrop stays transparent.
  bool visible = true;

 private:
  [[nodiscard]] Vec2 to_uv(const Vec3& direction) const;
  [[nodiscard]] Color texel(int x, int y) const;

  int width_ = 1;
  int height_ = 1;
  std::vector<Color> pixels_;
  std::optional<Distribution2D> distribution_;  ///< none for one colour: uniform over the sphere
  float intensity_ = 1.0f;
  float sin_rotation_ = 0.0f;
  float cos_rotation_ = 1.0f;
};

/// The light of a scene that has none of its own: an overcast sky over a pale floor with a large
/// soft window to the upper left. Not drawn behind the scene.
[[nodiscard]] Environment studio_environment();

}  // namespace lume::shading
