// SPDX-License-Identifier: Apache-2.0
#include "assets/generator/building_parts.h"

#include "assets/generator/fit_detail.h"

#include <algorithm>
#include <cmath>

namespace lume::generator {
namespace {

using geometry::k_pi;

/// A classical moulding's outline, a torus above a scotia: 0 at both ends, 1 at most.
float moulding(float v) { return std::sin(k_pi * v) * (0.7f + 0.3f * std::cos(3.0f * k_pi * v)); }

/// Half the thickness of a baluster at height v: a vase on a foot.
float baluster_radius(float v) {
  return 0.035f + 0.03f * std::sin(k_pi * v) * (1.0f - v) + 0.012f * std::cos(6.0f * k_pi * v);
}

}  // namespace

BuildingDetail BuildingDetail::of(double detail) {
  BuildingDetail result;
  result.storeys = detail < 1.6 ? 2 : 3;
  result.bays_long = segments_at(2.0, detail, 0.48, 12.0);
  result.bays_short = (result.bays_long + 1) / 2;
  result.column_around = segments_at(4.0, detail, 0.75);
  result.column_rows = segments_at(1.0, detail, 0.95);
  result.moulding_rows = segments_at(1.0, detail, 0.65);
  result.arch_segments = segments_at(2.0, detail, 0.7);
  result.balusters = segments_at(1.0, detail, 0.8, 30.0);
  result.baluster_around = segments_at(3.0, detail, 0.45);
  result.baluster_rows = segments_at(1.0, detail, 0.8);
  result.beams = segments_at(0.5, detail, 0.5, 6.0);
  result.panes = segments_at(0.5, detail, 0.5, 8.0);
  result.steps = segments_at(3.0, detail, 0.95, 34.0);
  return result;
}

void add_column(MeshBuilder& builder, const BuildingDetail& detail, float height) {
  constexpr float k_radius = 0.26f;
  constexpr float k_end = 0.35f;  // base and capital
  const float flutes = detail.column_around >= 40 ? 20.0f : 0.0f;
  // A flute needs two segments at least, or it is lost between the corners.
  const std::uint32_t columns =
      flutes > 0.0f ? detail.column_around / 20 * 20 : detail.column_around;
  builder.add_sheet({columns, detail.column_rows}, [&](float u, float v) {
    const float entasis = 1.0f - 0.15f * v * v;
    const float flute = 1.0f - 0.07f * std::abs(std::sin(flutes * k_pi * u));
    const Vec2 p = k_radius * entasis * flute * MeshBuilder::around(u);
    return Vec3(p.x, k_end + (height - 2.0f * k_end) * v, p.y);
  });
  if (detail.moulding_rows < 2) return;
  const Grid end{detail.column_around, detail.moulding_rows};
  builder.add_lathe(end, [&](float v) {
    return Vec2(k_radius + 0.1f * (1.0f - v) + 0.07f * moulding(v), 0.12f + (k_end - 0.12f) * v);
  });
  builder.add_lathe(end, [&](float v) {
    return Vec2(0.84f * k_radius + 0.12f * v * v + 0.05f * moulding(v),
                height - k_end + (k_end - 0.12f) * v);
  });
  builder.add_box({-0.38f, 0.0f, -0.38f}, {0.38f, 0.12f, 0.38f});
  builder.add_box({-0.36f, height - 0.12f, -0.36f}, {0.36f, height, 0.36f});
}

void add_arch(MeshBuilder& builder, const BuildingDetail& detail, float width, float height,
              float half_depth) {
  const float radius = 0.5f * width - 0.3f;
  const float rise = std::min(radius, height - 0.45f);
  const std::uint32_t s = detail.arch_segments;
  // From the left springing over the crown to the right one, `out` metres outside the opening.
  const auto curve = [=](float u, float out) {
    const float angle = k_pi * (1.0f - u);
    return Vec2(0.5f * width + (radius + out) * std::cos(angle), (rise + out) * std::sin(angle));
  };
  const auto spandrel = [&](float u, float v, float z) {
    const Vec2 p = curve(u, 0.0f);
    return Vec3(p.x, glm::mix(p.y, height, v), z);
  };
  builder.add_sheet({s, 1}, [&](float u, float v) { return spandrel(u, v, half_depth); });
  builder.add_sheet({s, 1}, [&](float u, float v) { return spandrel(1.0f - u, v, -half_depth); });
  builder.add_sheet({s, 1}, [&](float u, float v) {
    return Vec3(curve(u, 0.0f), half_depth * (2.0f * v - 1.0f));
  });
  builder.add_box({-0.3f, 0.0f, -half_depth}, {0.3f, height, half_depth});
  if (detail.moulding_rows < 2) return;
  builder.add_sheet({s, detail.moulding_rows}, [&](float u, float v) {
    return Vec3(curve(u, 0.22f * v), half_depth + 0.09f * moulding(v));
  });
}

void add_balusters(MeshBuilder& builder, const BuildingDetail& detail, float width, float height) {
  const Placement bay = builder.placement();
  for (std::uint32_t i = 0; i < detail.balusters; ++i) {
    const float x = (static_cast<float>(i) + 0.5f) / static_cast<float>(detail.balusters);
    builder.place(bay.moved({0.3f + (width - 0.6f) * x, 0.0f, 0.0f}));
    builder.add_lathe({detail.baluster_around, detail.baluster_rows},
                      [=](float v) { return Vec2(baluster_radius(v), height * v); });
  }
  builder.place(bay);
}

void add_cornice(MeshBuilder& builder, const BuildingDetail& detail, float length, float height) {
  builder.add_sheet({1, 2 * detail.moulding_rows}, [=](float u, float v) {
    return Vec3(length * u, height * v, height * (0.8f * v * v + 0.2f * moulding(v)));
  });
}

void add_window(MeshBuilder& builder, const BuildingDetail& detail, float width, float height) {
  const float half = 0.5f * width;
  const std::uint32_t n = detail.panes;
  for (std::uint32_t i = 0; i <= n; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(n);
    const float bar = i == 0 || i == n ? 0.08f : 0.02f;  // the frame, and what divides the panes
    const float x = glm::mix(-half, half, t);
    const float y = height * t;
    builder.add_box({x - bar, -bar, 0.0f}, {x + bar, height + bar, bar});
    builder.add_box({-half - bar, y - bar, 0.0f}, {half + bar, y + bar, bar});
  }
}

void add_stairs(MeshBuilder& builder, const BuildingDetail& detail, float run, float rise,
                float width) {
  constexpr float k_rail = 0.95f;
  const auto count = static_cast<float>(detail.steps);
  const float tread = run / count;
  const float riser = rise / count;
  const float thickness = detail.moulding_rows > 1 ? 0.05f : 2.0f * riser;
  const Placement foot = builder.placement();
  for (std::uint32_t i = 0; i < detail.steps; ++i) {
    const float x = tread * static_cast<float>(i);
    const float y = riser * static_cast<float>(i + 1);
    builder.add_box({x - 0.03f, y - thickness, 0.0f}, {x + tread, y, width});
    if (detail.moulding_rows > 1) {  // the nosing stands out over this
      builder.add_box({x, y - 2.0f * riser, 0.05f}, {x + tread, y - 0.05f, width - 0.05f});
    }
    builder.place(foot.moved({x + 0.5f * tread, y, width - 0.1f}));
    builder.add_lathe({detail.baluster_around, detail.baluster_rows},
                      [=](float v) { return Vec2(0.5f * baluster_radius(v), k_rail * v); });
    builder.place(foot);
  }
  const float z = width - 0.1f;
  add_bar(builder, {0, k_rail, z}, {run, rise + k_rail, z}, 0.08f);
}

void add_bar(MeshBuilder& builder, const Vec3& a, const Vec3& b, float thickness) {
  const Placement outer = builder.placement();
  const Vec3 along = normalize(b - a);
  const Vec3 side = normalize(cross(along, Vec3(0, 1, 0)));
  const Vec3 up = cross(side, along);
  const auto turned = [&](const Vec3& v) {
    return outer.axes[0] * v.x + outer.axes[1] * v.y + outer.axes[2] * v.z;
  };
  builder.place({outer.to_world(a), {turned(along), turned(up), turned(side)}});
  const float half = 0.5f * thickness;
  builder.add_box({0.0f, -half, -half}, {length(b - a), half, half});
  builder.place(outer);
}

}  // namespace lume::generator
