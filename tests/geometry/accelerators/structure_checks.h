// SPDX-License-Identifier: Apache-2.0
// What every structure has to stand, whatever it does inside: worlds of every kind, and rays along
// its planes.
#pragma once

#include "tests/support/agreement.h"
#include "tests/support/cases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lume::test {

inline void expect_agreement_in_mixed_worlds(std::string_view name) {
  Random random(1);
  int hits = 0;
  for (int round = 0; round < 15 && !::testing::Test::HasFailure(); ++round) {
    const geometry::World world = mixed_world(random);
    hits += expect_agreement(name, world, nullptr, cases(2000), [&] { return random_ray(random); });
    hits += expect_agreement(name, world, nullptr, cases(500), [&] { return axis_ray(random); });
    // From far away, where the ray's own rounding is larger than what it meets.
    hits += expect_agreement(name, world, nullptr, 100, [&] {
      geometry::Ray ray = random_ray(random);
      ray.t_max = std::numeric_limits<float>::infinity();
      ray.origin -= 1e9f * ray.direction;
      return ray;
    });
  }
  EXPECT_GT(hits, cases(10000));
}

inline void expect_agreement_in_tied_worlds(std::string_view name) {
  Random random(2);
  int hits = 0;
  for (int round = 0; round < 15 && !::testing::Test::HasFailure(); ++round) {
    const geometry::World world = tied_world(random);
    hits += expect_agreement(name, world, nullptr, cases(2000), [&] { return random_ray(random); });
    hits += expect_agreement(name, world, nullptr, cases(2000), [&] { return axis_ray(random); });
  }
  EXPECT_GT(hits, cases(3000));
}

/// A hole wherever the first coordinate is below a half.
class HalfHoles final : public geometry::HoleTest {
 public:
  bool is_hole(const geometry::Hit&, geometry::Vec2 uv) const override { return uv.x < 0.5f; }
};

inline void expect_agreement_beside_holes(std::string_view name) {
  Random random(3);
  const HalfHoles holes;
  int hits = 0;
  for (int round = 0; round < 10 && !::testing::Test::HasFailure(); ++round) {
    geometry::World world = mixed_world(random);
    for (geometry::Object& object : world.objects) object.geometries[0].has_holes = true;
    hits += expect_agreement(name, world, &holes, cases(1500), [&] { return random_ray(random); });
  }
  EXPECT_GT(hits, cases(2500));
}

/// A mesh that is hard on a builder, and where its rays are.
struct HardMesh {
  std::string name;
  geometry::Mesh mesh;
  int least_hits = 0;  ///< of 4000 rays
  geometry::Vec3 middle{0.0f};
  float reach = 12.0f;
};

inline void add_triangle(geometry::Mesh& mesh, const geometry::Vec3& a, const geometry::Vec3& b,
                         const geometry::Vec3& c) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {a, b, c});
  mesh.triangles.emplace_back(first, first + 1, first + 2);
}

/// Every position times `scale`, axis by axis, plus `offset`.
inline geometry::Mesh moved(geometry::Mesh mesh, const geometry::Vec3& scale,
                            const geometry::Vec3& offset = geometry::Vec3(0.0f)) {
  for (geometry::Vec3& p : mesh.positions) p = p * scale + offset;
  return mesh;
}

/// `count` times the same triangle, or with `around` different ones around the same point.
inline geometry::Mesh triangles_in_one_place(Random& random, int count, bool around) {
  geometry::Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const geometry::Vec3 arm = random.cube(5.0f);
    if (around) {
      add_triangle(mesh, -arm, arm, geometry::Vec3(arm.x, -arm.y, arm.z));
    } else {
      add_triangle(mesh, {-3, -3, 0}, {3, -3, 0}, {0, 3, 1});
    }
  }
  return mesh;
}

/// Points and lines, in general places and along axes, and one real triangle.
inline geometry::Mesh triangles_without_area(Random& random) {
  using geometry::Vec3;
  geometry::Mesh mesh;
  for (int i = 0; i < 50; ++i) {
    const Vec3 a = glm::round(random.cube(4.0f));
    const Vec3 b = random.cube(4.0f);
    add_triangle(mesh, a, a, a);
    add_triangle(mesh, a, b, a);
    add_triangle(mesh, a, a + Vec3(1, 0, 0), a + Vec3(3, 0, 0));
  }
  add_triangle(mesh, {-5, -5, 0}, {5, -5, 0}, {0, 5, 0});
  return mesh;
}

/// Unit squares on whole coordinates, across the axis: all of them along planes that halve space.
inline geometry::Mesh city_blocks(Random& random) {
  using geometry::Vec3;
  geometry::Mesh mesh;
  for (int i = 0; i < 300; ++i) {
    const Vec3 a = glm::round(random.cube(4.0f));
    const int axis = i % 3;
    Vec3 u(0.0f), v(0.0f);
    u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1.0f;
    add_triangle(mesh, a, a + u, a + v);
    add_triangle(mesh, a + u, a + u + v, a + v);
  }
  return mesh;
}

inline geometry::Mesh huge_among_tiny(Random& random) {
  using geometry::Vec3;
  geometry::Mesh mesh = triangle_soup(random, 400, 1.0f, 0.05f);
  add_triangle(mesh, {-9e5f, -8e5f, 0.3f}, {9e5f, -8e5f, -0.3f}, {0.0f, 9e5f, 0.2f});
  return mesh;
}

inline std::vector<HardMesh> hard_meshes(Random& random) {
  using geometry::Vec3;
  const geometry::Mesh soup = triangle_soup(random, 200, 4.0f, 2.0f);
  geometry::Mesh one;
  add_triangle(one, {-3, -3, 0}, {3, -3, 0}, {0, 3, 1});
  return {
      {"nothing", {}},
      {"one triangle", one, 50},
      {"all in one place", triangles_in_one_place(random, 300, false), 50},
      {"around one point", triangles_in_one_place(random, 300, true), 500},
      {"without area", triangles_without_area(random), 50},
      {"city blocks", city_blocks(random), 500},
      {"flat", moved(soup, {1.0f, 1.0f, 0.0f}), 500},
      {"flat, and askew by a rounding", moved(soup, {1.0f, 1.0f, 1e-30f}), 500},
      {"in a line", moved(soup, {1.0f, 1e-6f, 1e-6f}), 0},
      {"long", moved(soup, {1e4f, 1.0f, 1.0f}), 500},
      {"huge among tiny", huge_among_tiny(random), 500, Vec3(0.0f), 2.0f},
      {"immense", moved(soup, Vec3(1e30f)), 500, Vec3(0.0f), 1e17f},
      {"as large as can be", moved(soup, Vec3(5e37f)), 500, Vec3(0.0f), 1e17f},
      {"far away", moved(soup, Vec3(1.0f), {1e6f, -1e6f, 1e6f}), 500, {1e6f, -1e6f, 1e6f}},
      {"tiny", moved(soup, Vec3(1e-20f)), 500, Vec3(0.0f), 12e-20f},
      {"tiny in the distance", moved(soup, Vec3(1e-3f), {100, 1, 10}), 500, {100, 1, 10}, 12e-3f},
  };
}

inline void expect_agreement_in_hard_meshes(std::string_view name) {
  Random random(4);
  for (const HardMesh& hard : hard_meshes(random)) {
    SCOPED_TRACE(hard.name);
    geometry::World world;
    add_instance(world, hard.mesh);
    const auto any_ray = [&] {
      geometry::Ray ray{.origin = hard.middle + random.cube(hard.reach)};
      ray.direction = hard.middle + random.cube(0.7f * hard.reach) - ray.origin;
      return ray;
    };
    const auto ray_along_planes = [&] {
      geometry::Ray ray = axis_ray(random);
      ray.origin += hard.middle;
      return ray;
    };
    const int hits = expect_agreement(name, world, nullptr, cases(4000), any_ray);
    EXPECT_GE(hits, cases(hard.least_hits));
    expect_agreement(name, world, nullptr, cases(2000), ray_along_planes);
    if (::testing::Test::HasFailure()) return;
  }
}

inline void expect_shapes_alone_are_met(std::string_view name) {
  geometry::World world;
  EXPECT_FALSE(make_accelerator(name, world, nullptr)->closest_hit({}));
  add_instance(world, geometry::Sphere{1.0});
  const auto accelerator = make_accelerator(name, world, nullptr);
  EXPECT_EQ(accelerator->closest_hit({.origin = {0, 0, 3}}), geometry::Hit{});
  EXPECT_FALSE(accelerator->any_hit({.origin = {0, 2, 3}}));
}

}  // namespace lume::test
