// SPDX-License-Identifier: Apache-2.0
// An open atrium: a court of 24 by 12 metres, galleries on columns and arches around it, sky above.
// Beams and cornices are single triangles as long as the building, balusters and mouldings have
// triangles of millimetres: no split of space suits both.
#include "assets/generator/building_parts.h"
#include "assets/generator/characters.h"
#include "assets/generator/fit_detail.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lume::generator {
namespace {

constexpr float k_length = 24.0f;  // of the court, along x
constexpr float k_width = 12.0f;   // along z
constexpr float k_gallery = 3.6f;  // from the columns to the outer wall
constexpr float k_storey = 5.0f;   // from floor to floor
constexpr float k_column = 3.2f;   // height
constexpr float k_half_depth = 0.25f;
constexpr float k_slab = 0.3f;

/// One side of the court: its placement has x along the columns and z towards the court.
struct Side {
  Placement placement;
  float length = 0.0f;
  std::uint32_t bays = 0;
};

Side side_of(const BuildingDetail& detail, int number) {
  const float x = (number == 0 || number == 1 ? -0.5f : 0.5f) * k_length;
  const float z = (number == 0 || number == 3 ? -0.5f : 0.5f) * k_width;
  const bool is_long = number % 2 == 0;
  return {quarter_turns({x, 0, z}, number), is_long ? k_length : k_width,
          is_long ? detail.bays_long : detail.bays_short};
}

void add_bay(MeshBuilder& builder, const BuildingDetail& detail, float width, bool balustrade) {
  const Placement bay = builder.placement();
  add_column(builder, detail, k_column);
  builder.place(bay.moved({0, k_column, 0}));
  add_arch(builder, detail, width, k_storey - k_slab - k_column, k_half_depth);
  if (detail.panes > 0) {
    builder.place(bay.moved({0.5f * width, 1.0f, -k_gallery}));
    add_window(builder, detail, 0.5f * width, 2.2f);
  }
  if (balustrade) {
    builder.place(bay.moved({0, 0.1f, 0}));
    add_balusters(builder, detail, width, 0.8f);
  }
  builder.place(bay);
  for (std::uint32_t i = 0; i < detail.beams; ++i) {
    const float x = width * static_cast<float>(i) / static_cast<float>(detail.beams);
    const float top = k_storey - k_slab;
    builder.add_box({x - 0.09f, top - 0.28f, -k_gallery}, {x + 0.09f, top, 0});
  }
}

void add_storey(MeshBuilder& builder, const BuildingDetail& detail, const Side& side, bool upper) {
  const Placement start = builder.placement();
  const float width = side.length / static_cast<float>(side.bays);
  for (std::uint32_t bay = 0; bay < side.bays; ++bay) {
    builder.place(start.moved({width * static_cast<float>(bay), 0, 0}));
    add_bay(builder, detail, width, upper);
  }
  builder.place(start);
  if (upper) {
    if (detail.moulding_rows > 1) builder.add_box({0, 0.02f, -0.08f}, {side.length, 0.1f, 0.08f});
    builder.add_box({0, 0.9f, -0.1f}, {side.length, 1.0f, 0.1f});
  }
  // Each side has the corner where it starts; the next one goes on from there.
  builder.add_box({-k_gallery, k_storey - k_slab, -k_gallery},
                  {side.length, k_storey, k_half_depth});
  builder.place(start.moved({0, k_storey - k_slab, k_half_depth}));
  add_cornice(builder, detail, side.length, k_slab);
  builder.place(start);
  builder.add_sheet({1, 1}, [&](float u, float v) {
    return Vec3(glm::mix(-k_gallery, side.length + k_gallery, u), glm::mix(-0.1f, k_storey, v),
                -k_gallery);
  });
}

/// Trusses of thin bars across the court, and nothing on them.
void add_roof(MeshBuilder& builder, const BuildingDetail& detail) {
  const float base = k_storey * static_cast<float>(detail.storeys);
  const float half = 0.5f * k_width;
  for (std::uint32_t i = 1; i < detail.bays_long; ++i) {
    const float x =
        k_length * (static_cast<float>(i) / static_cast<float>(detail.bays_long) - 0.5f);
    const Vec3 ridge(x, base + 2.4f, 0);
    add_bar(builder, {x, base, -half}, {x, base, half}, 0.16f);
    for (const float side : {-half, half}) {
      add_bar(builder, {x, base, side}, ridge, 0.16f);
      add_bar(builder, {x, base, 0.1f * side}, {x, base + 1.2f, 0.5f * side}, 0.08f);
    }
  }
  add_bar(builder, {-0.5f * k_length, base + 2.4f, 0}, {0.5f * k_length, base + 2.4f, 0}, 0.2f);
}

void add_frame(MeshBuilder& builder, const BuildingDetail& detail) {
  for (int number = 0; number < 4; ++number) {
    const Side side = side_of(detail, number);
    for (std::uint32_t storey = 0; storey < detail.storeys; ++storey) {
      builder.place(side.placement.moved({0, k_storey * static_cast<float>(storey), 0}));
      add_storey(builder, detail, side, storey > 0);
    }
    if (number % 2 != 0) continue;
    builder.place(side.placement.moved({0.45f * side.length, 0, 0.35f}));
    add_stairs(builder, detail, 0.4f * side.length, k_storey, 1.5f);
  }
  builder.place({});
  add_roof(builder, detail);
  const Vec3 corner(0.5f * k_length + k_gallery, 0, 0.5f * k_width + k_gallery);
  builder.add_box({-corner.x, -0.5f, -corner.z}, {corner.x, -0.02f, corner.z});
}

/// Bevelled tiles over court and galleries: as many as it takes to have about `triangles`.
void add_floor(MeshBuilder& builder, std::size_t triangles) {
  constexpr float k_x = 0.5f * k_length + k_gallery;
  constexpr float k_z = 0.5f * k_width + k_gallery;
  constexpr float k_bevel = 0.04f;
  const double tiles = std::max(1.0, static_cast<double>(triangles) / 10.0);
  const auto columns = static_cast<std::uint32_t>(std::ceil(std::sqrt(tiles * (k_x / k_z))));
  const auto rows = static_cast<std::uint32_t>(std::max(1.0, tiles / columns + 0.5));
  const Vec2 size(2.0f * k_x / static_cast<float>(columns), 2.0f * k_z / static_cast<float>(rows));
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      builder.place({Vec3(-k_x + size.x * (static_cast<float>(i) + 0.5f), 0,
                          -k_z + size.y * (static_cast<float>(j) + 0.5f))});
      // A pyramid cut off near its base: four rows around it, with a square on top.
      const Vec2 outer = 0.5f * size;
      const Vec2 inner = outer * (1.0f - k_bevel);
      constexpr std::array<Vec2, 5> k_corners = {Vec2(-1, 1), Vec2(1, 1), Vec2(1, -1), Vec2(-1, -1),
                                                 Vec2(-1, 1)};
      builder.add_sheet({4, 1}, [&](float u, float v) {
        const Vec2 corner = k_corners[static_cast<std::size_t>(4.0f * u)] * (v > 0 ? inner : outer);
        return Vec3(corner.x, v > 0 ? 0.0f : -0.015f, corner.y);
      });
      builder.add_sheet({1, 1}, [&](float u, float v) {
        return Vec3(inner.x * (2.0f * u - 1.0f), 0.0f, inner.y * (1.0f - 2.0f * v));
      });
    }
  }
}

MeshBuilder counted_frame(double detail) {
  MeshBuilder counter;
  add_frame(counter, BuildingDetail::of(detail));
  return counter;
}

}  // namespace

geometry::Mesh architecture(std::size_t triangles) {
  // The floor makes up for the steps in which the rest grows.
  const double detail = fit_detail(triangles * 17 / 20, [](double candidate) {
    return counted_frame(candidate).triangle_count();
  });
  MeshBuilder counter = counted_frame(detail);
  const std::size_t left = triangles - std::min(triangles, counter.triangle_count());
  add_floor(counter, left);
  MeshBuilder builder = MeshBuilder::with_room_for(counter);
  add_frame(builder, BuildingDetail::of(detail));
  add_floor(builder, left);
  return builder.take();
}

}  // namespace lume::generator
