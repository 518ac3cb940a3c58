// SPDX-License-Identifier: Apache-2.0
#include "assets/generator/teapot.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lume::generator {
namespace {

/// The lowest and the highest of four control points are on the curve.
template <class Point>
Point bezier(const std::array<Point, 4>& p, float t) {
  const float s = 1.0f - t;
  return s * s * s * p[0] + 3.0f * s * s * t * p[1] + 3.0f * s * t * t * p[2] + t * t * t * p[3];
}

// Newell's numbers: one of his units is a bit more than 4 cm here. They are in scripts/scenes too.
constexpr float k_unit = k_teapot_width / 6.435f;

/// A part of the outline by (distance from the axis, height), from below to above on the outside.
struct Outline {
  std::array<Vec2, 4> points{};
  Poles poles = Poles::none;
};

constexpr std::array<Outline, 6> k_outlines = {{
    {{Vec2(0, 0), Vec2(1.425f, 0), Vec2(1.5f, 0.075f), Vec2(1.5f, 0.15f)}, Poles::first_row},
    {{Vec2(1.5f, 0.15f), Vec2(1.5f, 0.225f), Vec2(2, 0.45f), Vec2(2, 0.9f)}},
    {{Vec2(2, 0.9f), Vec2(2, 1.35f), Vec2(1.75f, 1.875f), Vec2(1.5f, 2.4f)}},
    {{Vec2(1.5f, 2.4f), Vec2(1.4375f, 2.53125f), Vec2(1.3375f, 2.53125f), Vec2(1.4f, 2.4f)}},
    {{Vec2(1.3f, 2.4f), Vec2(1.3f, 2.55f), Vec2(0.4f, 2.55f), Vec2(0.2f, 2.7f)}},
    {{Vec2(0.2f, 2.7f), Vec2(0, 2.85f), Vec2(0.8f, 3.15f), Vec2(0, 3.15f)}, Poles::last_row},
}};

/// A piece of a flattened tube: four cross-sections, of each the point at its inner and at its
/// outer side as (x, y), and how far it bulges to either side in z.
struct Section {
  Vec2 inner;
  Vec2 outer;
  float bulge;
};
using Tube = std::array<Section, 4>;

constexpr std::array<Tube, 4> k_tubes = {{
    // handle: from the rim outwards, and down to the body
    {{{{-1.6f, 2.025f}, {-1.5f, 2.25f}, 0.3f},
      {{-2.3f, 2.025f}, {-2.5f, 2.25f}, 0.3f},
      {{-2.7f, 2.025f}, {-3.0f, 2.25f}, 0.3f},
      {{-2.7f, 1.8f}, {-3.0f, 1.8f}, 0.3f}}},
    {{{{-2.7f, 1.8f}, {-3.0f, 1.8f}, 0.3f},
      {{-2.7f, 1.575f}, {-3.0f, 1.35f}, 0.3f},
      {{-2.5f, 1.125f}, {-2.65f, 0.9375f}, 0.3f},
      {{-2.0f, 0.9f}, {-1.9f, 0.6f}, 0.3f}}},
    // spout: from the body to the lip, and over it
    {{{{1.7f, 1.425f}, {1.7f, 0.6f}, 0.66f},
      {{2.6f, 1.425f}, {3.1f, 0.825f}, 0.66f},
      {{2.3f, 2.1f}, {2.4f, 2.025f}, 0.25f},
      {{2.7f, 2.4f}, {3.3f, 2.4f}, 0.25f}}},
    {{{{2.7f, 2.4f}, {3.3f, 2.4f}, 0.25f},
      {{2.8f, 2.475f}, {3.525f, 2.49375f}, 0.25f},
      {{2.9f, 2.475f}, {3.45f, 2.5125f}, 0.15f},
      {{2.8f, 2.4f}, {3.2f, 2.4f}, 0.15f}}},
}};

/// The half of a tube's surface on the side of `sign` in z: across it goes around the tube.
Vec3 tube_point(const Tube& tube, float across, float along, float sign) {
  std::array<Vec3, 4> ring{};
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<Vec3, 4> curve{};
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec2& p = i < 2 ? tube[k].inner : tube[k].outer;
      curve[k] = Vec3(p, i == 1 || i == 2 ? sign * tube[k].bulge : 0.0f);
    }
    ring[i] = bezier(curve, along);
  }
  return k_unit * bezier(ring, across);
}

}  // namespace

TeapotDetail TeapotDetail::of(std::size_t triangles) {
  // Six outlines of rows * around quads less two poles, eight half tubes of rows * rows.
  const auto count = static_cast<double>(triangles);
  const double rows = std::max(1.0, std::floor(std::sqrt(count / 64.0)));
  const double around = (count - 16.0 * rows * rows) / (12.0 * rows - 2.0);
  return {static_cast<std::uint32_t>(rows), static_cast<std::uint32_t>(std::max(3.0, around))};
}

void add_teapot(MeshBuilder& builder, const TeapotDetail& detail) {
  for (const Outline& outline : k_outlines) {
    builder.add_lathe({detail.around, detail.rows, outline.poles},
                      [&](float v) { return k_unit * bezier(outline.points, v); });
  }
  for (const Tube& tube : k_tubes) {
    builder.add_sheet({detail.rows, detail.rows},
                      [&](float u, float v) { return tube_point(tube, v, u, 1.0f); });
    builder.add_sheet({detail.rows, detail.rows},
                      [&](float u, float v) { return tube_point(tube, 1.0f - v, u, -1.0f); });
  }
}

}  // namespace lume::generator
