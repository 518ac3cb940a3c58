// SPDX-License-Identifier: Apache-2.0
// The teapot in a stadium: a small thing of very many triangles in a world of few and huge ones. A
// uniform grid has one cell for all of the teapot; a split in the middle of space says nothing
// about where the triangles are.
#include "assets/generator/characters.h"
#include "assets/generator/mesh_builder.h"
#include "assets/generator/teapot.h"

#include <algorithm>
#include <cmath>

namespace lume::generator {
namespace {

constexpr float k_table = 0.9f;  // the height of what the teapot stands on

/// The stadium's divisions; it has 4 * sectors * (tiers + 1) triangles.
struct StadiumDetail {
  std::uint32_t sectors = 16;
  std::uint32_t tiers = 2;

  /// A twentieth of the triangles where that is enough to look like a stadium, and at most some
  /// thousands: it is the teapot that grows.
  [[nodiscard]] static StadiumDetail of(std::size_t triangles) {
    const double count = std::clamp(0.05 * static_cast<double>(triangles), 100.0, 8000.0);
    const auto tiers = static_cast<std::uint32_t>(std::clamp(std::sqrt(count / 20.0), 2.0, 18.0));
    return {static_cast<std::uint32_t>(count) / (6 * tiers), tiers};
  }
};

/// A point of the oval at `u` of its length, `out` metres outside the field's edge.
Vec3 oval(float u, float out, float height) {
  const Vec2 direction = MeshBuilder::around(u);
  return {(85.0f + out) * direction.x, height, (55.0f + out) * direction.y};
}

/// A ring of steps for each tier, seen from the field.
void add_tiers(MeshBuilder& builder, const StadiumDetail& detail) {
  constexpr float k_depth = 62.0f;
  constexpr float k_height = 24.0f;
  const auto tiers = static_cast<float>(detail.tiers);
  for (std::uint32_t tier = 0; tier < detail.tiers; ++tier) {
    const auto number = static_cast<float>(tier);
    const float inner = 3.0f + k_depth * number / tiers;
    const float outer = 3.0f + k_depth * (number + 1.0f) / tiers;
    // Each row is steeper than the one below it, so that all see the field.
    const auto height_of = [=](float row) { return k_height * std::pow(row / tiers, 1.3f); };
    const float floor = height_of(number);
    const float top = height_of(number + 1.0f);
    builder.add_sheet({detail.sectors, 1}, [=](float u, float v) {
      return oval(1.0f - u, inner, glm::mix(floor, top, v));
    });
    builder.add_sheet({detail.sectors, 1}, [=](float u, float v) {
      return oval(1.0f - u, glm::mix(inner, outer, v), top);
    });
  }
  // The outer wall, and the roof that leans over the highest rows.
  const float edge = 3.0f + k_depth;
  builder.add_sheet({detail.sectors, 1},
                    [=](float u, float v) { return oval(u, edge, 1.45f * k_height * v); });
  builder.add_sheet({detail.sectors, 1}, [=](float u, float v) {
    return oval(u, edge - 14.0f * v, k_height * (1.45f + 0.05f * v));
  });
}

void add_all(MeshBuilder& builder, const StadiumDetail& stadium, const TeapotDetail& teapot) {
  constexpr float k_half = 400.0f;
  builder.add_sheet({1, 1}, [](float u, float v) {
    return Vec3(k_half * (2.0f * u - 1.0f), 0.0f, k_half * (1.0f - 2.0f * v));
  });
  add_tiers(builder, stadium);
  builder.add_box({-0.22f, k_table - 0.03f, -0.16f}, {0.22f, k_table, 0.16f});
  builder.add_box({-0.05f, 0.0f, -0.05f}, {0.05f, k_table - 0.03f, 0.05f});
  builder.place({Vec3(0, k_table, 0)});
  add_teapot(builder, teapot);
  builder.place({});
}

}  // namespace

geometry::Mesh stadium(std::size_t triangles) {
  const StadiumDetail detail = StadiumDetail::of(triangles);
  MeshBuilder arena;
  add_tiers(arena, detail);
  const TeapotDetail teapot = TeapotDetail::of(triangles - arena.triangle_count() - 26);
  MeshBuilder counter;
  add_all(counter, detail, teapot);
  MeshBuilder builder = MeshBuilder::with_room_for(counter);
  add_all(builder, detail, teapot);
  return builder.take();
}

}  // namespace lume::generator
