// SPDX-License-Identifier: Apache-2.0
#include "renderer/pixel_filter.h"

#include <array>
#include <cmath>
#include <vector>

namespace lume::renderer {
namespace {

constexpr std::array<std::string_view, 4> k_names = {"box", "triangle", "gaussian",
                                                     "blackman-harris"};
constexpr std::array<float, 4> k_usual_radius = {0.5f, 1.0f, 1.5f, 1.5f};
/// The filter at x, in radii from its centre.
float evaluate(PixelFilter::Kind kind, float x) {
  using Kind = PixelFilter::Kind;
  const float t = std::abs(x);
  if (t > 1.0f) return 0.0f;
  switch (kind) {
    case Kind::box:
      return 1.0f;
    case Kind::triangle:
      return 1.0f - t;
    case Kind::gaussian: {
      // Standard deviation a third of the radius, lowered to reach 0 at the radius.
      constexpr float k_edge = 0.011108997f;  // exp(-4.5)
      return std::exp(-4.5f * t * t) - k_edge;
    }
    case Kind::blackman_harris: {
      // Harris 1978, "On the Use of Windows for Harmonic Analysis", the minimum 4-term window.
      const float phase = geometry::k_pi * (1.0f + t);
      return 0.35875f - 0.48829f * std::cos(phase) + 0.14128f * std::cos(2.0f * phase) -
             0.01168f * std::cos(3.0f * phase);
    }
  }
  return 0.0f;
}

/// The filter at the middles of equal cells from one end of its support to the other.
std::vector<float> tabulate(PixelFilter::Kind kind) {
  constexpr std::size_t k_cells = 512;
  std::vector<float> values(k_cells);
  for (std::size_t i = 0; i < k_cells; ++i) {
    const float unit = (static_cast<float>(i) + 0.5f) / static_cast<float>(k_cells);
    values[i] = evaluate(kind, 2.0f * unit - 1.0f);
  }
  return values;
}

}  // namespace

std::span<const std::string_view> PixelFilter::names() { return k_names; }

PixelFilter::PixelFilter(Kind kind, float radius)
    : kind_(kind),
      radius_(radius > 0.0f ? radius : k_usual_radius[static_cast<std::size_t>(kind)]),
      distribution_(tabulate(kind)) {}

float PixelFilter::evaluate(float x) const { return renderer::evaluate(kind_, x / radius_); }

}  // namespace lume::renderer
