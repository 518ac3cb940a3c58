// SPDX-License-Identifier: Apache-2.0
// Worlds of every kind, rays through them, and the question whether an accelerator names for each
// ray the very primitive that brute force names.
#pragma once

#include "geometry/accelerators/accelerator.h"
#include "tests/support/random.h"
#include "tests/support/worlds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>
#include <vector>

namespace lume::test {

/// A ray through the middle of a world of the given size; one in three ends on its way.
inline geometry::Ray random_ray(Random& random, float reach = 12.0f) {
  geometry::Ray ray{.origin = random.cube(reach), .direction = random.cube(8.0f)};
  ray.direction -= ray.origin;
  if (random.uniform() < 0.3f) ray.t_max = random.uniform(0.2f, 1.5f);
  return ray;
}

/// A ray along an axis, from a corner of a grid of small whole numbers: through edges, corners and
/// planes of boxes that are there too.
inline geometry::Ray axis_ray(Random& random) {
  geometry::Ray ray{.origin = glm::round(random.cube(6.0f)), .direction = geometry::Vec3(0.0f)};
  ray.direction[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 1.0f : -1.0f;
  return ray;
}

/// Meshes, shapes and objects of both, under random affine transforms, some of them more than once,
/// and a plane without an end.
inline geometry::World mixed_world(Random& random) {
  using geometry::Box;
  using geometry::Plane;
  using geometry::Shape;
  using geometry::Sphere;
  using geometry::Torus;
  using geometry::Transform;
  geometry::World world;
  for (int object = 0; object < 3; ++object) {
    world.objects.push_back({"",
                             {{triangle_soup(random, 40, 1.0f, 0.5f)},
                              {Shape(Sphere{0.6})},
                              {triangle_soup(random, 30, 1.0f, 0.5f)}}});
  }
  world.objects.push_back({"", {{Shape(Torus{0.7, 0.25})}, {Shape(Box{{0.5, 0.8, 0.3}})}}});
  world.objects.push_back({"", {{sphere_mesh(8)}}});
  for (std::uint32_t i = 0; i < 15; ++i) {
    world.instances.push_back({"", i % 5, Transform(random_transform(random, 5.0f))});
  }
  add_instance(world, Plane{}, random_transform(random, 5.0f));
  return world;
}

/// Squares on whole coordinates, many of them in the same place: ties for every ray that meets one.
inline geometry::World tied_world(Random& random) {
  geometry::World world;
  geometry::Mesh mesh = square_mesh();
  world.objects.push_back({"", {{mesh}, {mesh}}});
  for (int i = 0; i < 40; ++i) {
    geometry::DMat4 matrix(1.0);
    matrix[3] = glm::dvec4(geometry::DVec3(glm::round(random.cube(3.0f))), 1.0);
    world.instances.push_back({"", 0, geometry::Transform(matrix)});
  }
  return world;
}

/// For each of `count` rays that `make_ray` gives: the same closest hit as by brute force, counted
/// or not, and the same answer to any_hit. Returns how many met something.
template <class MakeRay>
int expect_agreement(std::string_view name, const geometry::World& world,
                     const geometry::HoleTest* holes, int count, const MakeRay& make_ray) {
  const auto accelerator = geometry::make_accelerator(name, world, holes);
  const auto oracle = geometry::make_accelerator("brute-force", world, holes);
  int hits = 0;
  for (int i = 0; i < count; ++i) {
    const geometry::Ray ray = make_ray();
    const auto expected = oracle->closest_hit(ray);
    EXPECT_EQ(accelerator->closest_hit(ray), expected) << name << ", ray " << i;
    EXPECT_EQ(accelerator->any_hit(ray), expected.has_value()) << name << ", ray " << i;
    if (expected) ++hits;
    if (::testing::Test::HasFailure()) break;
  }
  return hits;
}

}  // namespace lume::test
