// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/color_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lume::cli {
namespace {

using geometry::Vec3;

/// Linear Rec.709 of a colour by Oklab's lightness, chroma and hue (Ottosson 2020, "A perceptual
/// color space for image processing"), moved into what a display can show.
shading::Color from_oklch(float lightness, float chroma, float hue_degrees) {
  const float hue = hue_degrees * std::numbers::pi_v<float> / 180.0f;
  const float a = chroma * std::cos(hue);
  const float b = chroma * std::sin(hue);
  Vec3 lms(lightness + 0.3963377774f * a + 0.2158037573f * b,
           lightness - 0.1055613458f * a - 0.0638541728f * b,
           lightness - 0.0894841775f * a - 1.2914855480f * b);
  lms = lms * lms * lms;
  const Vec3 rgb(4.0767416621f * lms.x - 3.3077115913f * lms.y + 0.2309699292f * lms.z,
                 -1.2684380046f * lms.x + 2.6097574011f * lms.y - 0.3413193965f * lms.z,
                 -0.0041960863f * lms.x - 0.7034186147f * lms.y + 1.7076147010f * lms.z);
  return glm::clamp(rgb, Vec3(0.0f), Vec3(1.0f));
}

}  // namespace

shading::Color sequential_color(float value) {
  const float x = std::clamp(value, 0.0f, 1.0f);
  const float lightness = 0.25f + 0.67f * x;
  const float hue = 310.0f - 202.0f * x;
  const float chroma = 0.12f + 0.06f * x * x;
  return from_oklch(lightness, chroma, hue);
}

shading::Color diverging_color(float value) {
  const float x = std::clamp(value, -1.0f, 1.0f);
  const float distance = std::abs(x);
  return from_oklch(0.97f - 0.50f * distance, 0.17f * distance, x < 0.0f ? 255.0f : 29.0f);
}

}  // namespace lume::cli
