// SPDX-License-Identifier: Apache-2.0
// The map is interpolated bilinearly, and the density is constant over the solid angle of each
// texel: within a row sin(latitude) is drawn uniformly, so that no 1 / sin(theta) appears and the
// poles need no special case.
#include "shading/environment.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lume::shading {
namespace {

using geometry::k_pi;

constexpr float k_uniform_pdf = 1.0f / (4.0f * k_pi);

/// Steradians of each texel in row `row`: (2 pi / width) (cos theta_0 - cos theta_1).
float texel_solid_angle(int row, int width, int height) {
  const float half_step = 0.5f * k_pi / static_cast<float>(height);
  const float theta = (2.0f * static_cast<float>(row) + 1.0f) * half_step;
  return 4.0f * k_pi / static_cast<float>(width) * std::sin(theta) * std::sin(half_step);
}

Vec3 direction_of(float azimuth, float y) {
  const float radius = std::sqrt(std::max(0.0f, 1.0f - y * y));
  return {radius * std::cos(azimuth), y, radius * std::sin(azimuth)};
}

/// The mean of the bilinear interpolant over each texel: along an axis a texel and its neighbours
/// count 6/8 and 1/8. It is 0 only where the radiance is 0 in the whole texel.
std::vector<float> mean_luminances(int width, int height, const std::vector<Color>& pixels) {
  std::vector<float> means(pixels.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      float sum = 0.0f;
      for (int dy = -1; dy <= 1; ++dy) {
        const int row = std::clamp(y + dy, 0, height - 1);
        for (int dx = -1; dx <= 1; ++dx) {
          const int column = (x + dx + width) % width;
          const float weight = (dx == 0 ? 0.75f : 0.125f) * (dy == 0 ? 0.75f : 0.125f);
          sum += weight *
                 luminance(pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(column)]);
        }
      }
      means[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
            static_cast<std::size_t>(x)] = sum;
    }
  }
  return means;
}

std::vector<float> texel_weights(int width, int height, const std::vector<Color>& pixels) {
  std::vector<float> weights = mean_luminances(width, height, pixels);
  auto weight = weights.begin();
  for (int y = 0; y < height; ++y) {
    const float solid_angle = texel_solid_angle(y, width, height);
    for (int x = 0; x < width; ++x) *weight++ *= solid_angle;
  }
  return weights;
}

}  // namespace

Environment::Environment(const Color& radiance) : pixels_{radiance} {}

Environment::Environment(int width, int height, std::vector<Color> pixels)
    : width_(width), height_(height), pixels_(std::move(pixels)) {
  distribution_.emplace(width_, height_, texel_weights(width_, height_, pixels_));
}

void Environment::rotate(float angle) {
  const float c = std::cos(angle);
  const float s = std::sin(angle);
  const float old_cos = cos_rotation_;
  cos_rotation_ = old_cos * c - sin_rotation_ * s;
  sin_rotation_ = sin_rotation_ * c + old_cos * s;
}

void Environment::scale(float intensity) { intensity_ *= intensity; }

Vec2 Environment::to_uv(const Vec3& direction) const {
  // Back from the world into the map: the inverse of the turn around +y.
  const float x = cos_rotation_ * direction.x - sin_rotation_ * direction.z;
  const float z = sin_rotation_ * direction.x + cos_rotation_ * direction.z;
  return {0.5f + std::atan2(z, x) / (2.0f * k_pi),
          0.5f - std::asin(std::clamp(direction.y, -1.0f, 1.0f)) / k_pi};
}

Color Environment::texel(int x, int y) const {
  return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                 static_cast<std::size_t>(x)];
}

Color Environment::radiance(const Vec3& direction) const {
  if (!distribution_) return pixels_.front() * intensity_;
  const Vec2 uv = to_uv(direction);
  const float x = uv.x * static_cast<float>(width_) - 0.5f;
  const float y = uv.y * static_cast<float>(height_) - 0.5f;
  const float left = std::floor(x);
  const float top = std::floor(y);
  // u is in [0, 1], so each neighbour is at most one texel outside of the map.
  const int x0 = left < 0.0f ? width_ - 1 : static_cast<int>(left);
  const int x1 = x0 + 1 == width_ ? 0 : x0 + 1;
  const int y0 = std::clamp(static_cast<int>(top), 0, height_ - 1);
  const int y1 = std::clamp(static_cast<int>(top) + 1, 0, height_ - 1);
  const Color upper = glm::mix(texel(x0, y0), texel(x1, y0), x - left);
  const Color lower = glm::mix(texel(x0, y1), texel(x1, y1), x - left);
  return glm::mix(upper, lower, y - top) * intensity_;
}

DirectionSample Environment::sample(Vec2 random) const {
  if (!distribution_) {
    return {direction_of(2.0f * k_pi * random.x, 1.0f - 2.0f * random.y), k_uniform_pdf};
  }
  const Distribution2D::Sample drawn = distribution_->sample(random);
  const float v = drawn.position.y * static_cast<float>(height_);
  const int row = std::min(static_cast<int>(v), height_ - 1);
  const float step = k_pi / static_cast<float>(height_);
  const float y =
      glm::mix(std::cos(step * static_cast<float>(row)),
               std::cos(step * static_cast<float>(row + 1)), v - static_cast<float>(row));
  const Vec3 in_map = direction_of(2.0f * k_pi * (drawn.position.x - 0.5f), y);
  const float texels = static_cast<float>(width_) * static_cast<float>(height_);
  return {{cos_rotation_ * in_map.x + sin_rotation_ * in_map.z, in_map.y,
           cos_rotation_ * in_map.z - sin_rotation_ * in_map.x},
          drawn.pdf / (texels * texel_solid_angle(row, width_, height_))};
}

float Environment::pdf(const Vec3& direction) const {
  if (!distribution_) return k_uniform_pdf;
  const Vec2 uv = to_uv(direction);
  const int row = std::min(static_cast<int>(uv.y * static_cast<float>(height_)), height_ - 1);
  const float texels = static_cast<float>(width_) * static_cast<float>(height_);
  return distribution_->pdf(uv) / (texels * texel_solid_angle(row, width_, height_));
}

}  // namespace lume::shading
