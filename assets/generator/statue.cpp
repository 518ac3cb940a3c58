// SPDX-License-Identifier: Apache-2.0
// A dense closed surface as a scanner gives it: even triangles, shared vertices, no holes. The
// surface of a lattice box is stretched over the figure, so that it is closed by construction: its
// walls go around the body, its upper lid over the head and its lower one under the feet.
#include "assets/generator/characters.h"
#include "assets/generator/figure.h"
#include "assets/generator/mesh_builder.h"
#include "geometry/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lume::generator {
namespace {

constexpr float k_plinth_height = 0.55f;
constexpr float k_crown_elevation = 0.6f;  // radians, of the rays from the head's middle to the rim

/// The vertices of a box of `lid` x `lid` x `wall` cells, on its surface only: the rings of the
/// walls first, then the insides of the lower and of the upper lid.
struct Lattice {
  std::uint32_t lid = 1;
  std::uint32_t wall = 1;

  [[nodiscard]] std::uint32_t ring() const { return 4 * lid; }
  [[nodiscard]] std::uint32_t inside() const { return (lid - 1) * (lid - 1); }
  [[nodiscard]] std::uint32_t positions() const { return ring() * (wall + 1) + 2 * inside(); }
  [[nodiscard]] std::size_t triangles() const {
    return 2 * std::size_t{ring()} * wall + 4 * std::size_t{lid} * lid;
  }
  /// `around` up to ring(), which is 0 again.
  [[nodiscard]] std::uint32_t on_wall(std::uint32_t around, std::uint32_t row) const {
    return row * ring() + (around < ring() ? around : around - ring());
  }
  /// Corner (i, k) of a lid's cells; on its rim that is a vertex of the wall.
  [[nodiscard]] std::uint32_t on_lid(std::uint32_t i, std::uint32_t k, bool upper) const {
    const std::uint32_t row = upper ? wall : 0;
    if (k == lid) return on_wall(i, row);
    if (i == lid) return on_wall(2 * lid - k, row);
    if (k == 0) return on_wall(3 * lid - i, row);
    if (i == 0) return on_wall(3 * lid + k, row);
    return ring() * (wall + 1) + (upper ? inside() : 0) + (k - 1) * (lid - 1) + i - 1;
  }
};

/// The lattice of about `triangles` triangles whose cells are about square on the figure, which is
/// some twice as high as its girth is long; the feet's lid is small and flat.
Lattice choose_lattice(std::size_t triangles) {
  const auto count = static_cast<double>(triangles);
  Lattice lattice;
  lattice.lid = std::max(1u, static_cast<std::uint32_t>(std::sqrt(count / 44.0)));
  const double lids = 4.0 * lattice.lid * lattice.lid;
  lattice.wall = static_cast<std::uint32_t>(std::lround((count - lids) / (8.0 * lattice.lid)));
  return lattice;
}

/// Where a ray from `origin`, which is inside, first leaves the figure.
Vec3 leave_figure(const Vec3& origin, const Vec3& direction) {
  float t = 0.0f;
  for (int step = 0; step < 64; ++step) {
    const float distance = figure_distance(origin + t * direction);
    if (distance > -2e-5f) break;
    t -= distance;
  }
  const Vec3 p = origin + t * direction;
  return p + direction * figure_relief(p);
}

/// The direction from the y axis at angle 2 pi `around` (from +x towards -z, as on a lid) and an
/// elevation.
Vec3 direction_to(float around, float elevation) {
  const float angle = 2.0f * geometry::k_pi * around;
  const float across = std::cos(elevation);
  return {across * std::cos(angle), std::sin(elevation), -across * std::sin(angle)};
}

/// A point of the wall, v = 0 at the feet and 1 around the crown: the rays' origin climbs to the
/// head's middle, and they rise on the way.
Vec3 wall_point(float around, float v) {
  const float elevation = k_crown_elevation * v * v * v * v;
  return leave_figure({0, k_figure_eye_height * v, 0}, direction_to(around, elevation));
}

/// A point of a lid, at a fraction of its radius.
Vec3 lid_point(float around, float radius, bool upper) {
  if (!upper) {
    const Vec3 rim = wall_point(around, 0.0f);
    return {radius * rim.x, rim.y, radius * rim.z};
  }
  const float elevation = glm::mix(0.5f * geometry::k_pi, k_crown_elevation, radius);
  return leave_figure({0, k_figure_eye_height, 0}, direction_to(around, elevation));
}

/// Corner (i, k) of a lid as (turns around the middle, fraction of the radius): its squares become
/// circles, each evenly divided, from the same start as on_wall().
Vec2 disk_coordinates(std::uint32_t lid, std::uint32_t i, std::uint32_t k) {
  const float x = 2.0f * static_cast<float>(i) / static_cast<float>(lid) - 1.0f;
  const float z = 2.0f * static_cast<float>(k) / static_cast<float>(lid) - 1.0f;
  const float radius = std::max(std::abs(x), std::abs(z));
  if (radius == 0.0f) return {0.0f, 0.0f};
  float side = 0.0f;
  if (z == radius)
    side = 0.5f * (x / radius + 1.0f);
  else if (x == radius)
    side = 1.5f - 0.5f * z / radius;
  else if (z == -radius)
    side = 2.5f - 0.5f * x / radius;
  else
    side = 3.5f + 0.5f * z / radius;
  return {0.25f * side, radius};
}

void place_vertices(const Lattice& lattice, Mesh& mesh) {
  const Vec3 up(0, k_plinth_height - 0.01f, 0);  // the feet are a little inside the plinth
  geometry::parallel_for(lattice.wall + 1, [&](std::size_t number) {
    const auto row = static_cast<std::uint32_t>(number);
    const float v = static_cast<float>(row) / static_cast<float>(lattice.wall);
    for (std::uint32_t i = 0; i < lattice.ring(); ++i) {
      const float around = static_cast<float>(i) / static_cast<float>(lattice.ring());
      mesh.positions[lattice.on_wall(i, row)] = up + wall_point(around, v);
    }
  });
  geometry::parallel_for(lattice.lid - 1, [&](std::size_t number) {
    const auto k = static_cast<std::uint32_t>(number) + 1;
    for (std::uint32_t i = 1; i < lattice.lid; ++i) {
      const Vec2 disk = disk_coordinates(lattice.lid, i, k);
      for (const bool upper : {false, true}) {
        mesh.positions[lattice.on_lid(i, k, upper)] = up + lid_point(disk.x, disk.y, upper);
      }
    }
  });
}

void add_quad(Mesh& mesh, const std::array<std::uint32_t, 4>& q) {
  mesh.triangles.emplace_back(q[0], q[1], q[2]);
  mesh.triangles.emplace_back(q[0], q[2], q[3]);
}

void connect(const Lattice& lattice, Mesh& mesh) {
  for (std::uint32_t row = 0; row < lattice.wall; ++row) {
    for (std::uint32_t i = 0; i < lattice.ring(); ++i) {
      add_quad(mesh, {lattice.on_wall(i, row), lattice.on_wall(i + 1, row),
                      lattice.on_wall(i + 1, row + 1), lattice.on_wall(i, row + 1)});
    }
  }
  for (std::uint32_t k = 0; k < lattice.lid; ++k) {
    for (std::uint32_t i = 0; i < lattice.lid; ++i) {
      add_quad(mesh, {lattice.on_lid(i, k, true), lattice.on_lid(i, k + 1, true),
                      lattice.on_lid(i + 1, k + 1, true), lattice.on_lid(i + 1, k, true)});
      add_quad(mesh, {lattice.on_lid(i, k, false), lattice.on_lid(i + 1, k, false),
                      lattice.on_lid(i + 1, k + 1, false), lattice.on_lid(i, k + 1, false)});
    }
  }
}

/// A square moulded block below y = k_plinth_height, closed as the figure is.
void add_plinth(Mesh& mesh) {
  constexpr std::array<Vec2, 10> k_outline = {
      // half the width, height
      Vec2(0.52f, 0.0f),  Vec2(0.52f, 0.12f),          Vec2(0.48f, 0.14f), Vec2(0.44f, 0.18f),
      Vec2(0.42f, 0.22f), Vec2(0.42f, 0.40f),          Vec2(0.45f, 0.44f), Vec2(0.49f, 0.47f),
      Vec2(0.49f, 0.53f), Vec2(0.47f, k_plinth_height)};
  constexpr std::array<Vec2, 4> k_corners = {Vec2(-1, 1), Vec2(1, 1), Vec2(1, -1), Vec2(-1, -1)};
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vec2& ring : k_outline) {
    for (const Vec2& c : k_corners) mesh.positions.emplace_back(ring.x * c.x, ring.y, ring.x * c.y);
  }
  const auto last = first + static_cast<std::uint32_t>(4 * (k_outline.size() - 1));
  for (std::uint32_t ring = first; ring < last; ring += 4) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t next = (i + 1) % 4;
      add_quad(mesh, {ring + i, ring + next, ring + 4 + next, ring + 4 + i});
    }
  }
  add_quad(mesh, {last, last + 1, last + 2, last + 3});
  add_quad(mesh, {first + 3, first + 2, first + 1, first});
}

}  // namespace

geometry::Mesh statue(std::size_t triangles) {
  constexpr std::size_t k_plinth_triangles = 76;
  constexpr std::size_t k_plinth_positions = 40;
  const Lattice lattice = choose_lattice(triangles - k_plinth_triangles);
  Mesh mesh;
  mesh.positions.reserve(lattice.positions() + k_plinth_positions);
  mesh.positions.resize(lattice.positions());
  mesh.triangles.reserve(lattice.triangles() + k_plinth_triangles);
  place_vertices(lattice, mesh);
  connect(lattice, mesh);
  add_plinth(mesh);
  return mesh;
}

}  // namespace lume::generator
