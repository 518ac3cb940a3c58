// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/zbuffer/raster.h"
#include "geometry/accelerators/zbuffer/tile_lists.h"
#include "geometry/parallel.h"
#include "tests/geometry/accelerators/structure_checks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lume::geometry {
namespace {

using test::Random;

constexpr int k_width = 80;
constexpr int k_height = 50;

/// The ray of a place in the picture or a few pixels beside it; some through the corners of pixels,
/// and some that end on their way.
Ray camera_ray(Random& random, const Camera& camera) {
  const Vec2 size(k_width, k_height);
  Vec2 pixel = random.square() * (size + 6.0f) - 3.0f;
  if (random.below(4) == 0) pixel = glm::round(pixel);
  Ray ray = camera.generate_ray(pixel / size, size.x / size.y);
  if (random.below(8) == 0) ray.t_max = random.uniform(0.5f, 15.0f);
  return ray;
}

/// In a cube around a place, or far from it, looking at something near the place.
Camera random_camera(Random& random, const Vec3& place = Vec3(0.0f), float size = 1.0f) {
  const float reach = random.below(3) == 0 ? 30.0f : 6.0f;
  Camera camera =
      look_at(place + size * random.cube(reach), place + size * random.cube(4.0f), 0.8f);
  if (random.below(3) == 0) {
    camera.projection = Camera::Projection::orthographic;
    camera.half_height = size * random.uniform(1.0f, 8.0f);
  } else {
    camera.vertical_fov = random.uniform(0.1f, 2.2f);
  }
  return camera;
}

/// For `count` rays of the camera the same hits as by brute force, and all of them by the raster
/// if the world is `in_reach`.
/// Returns how many met something.
int expect_same_picture(const World& world, const HoleTest* holes, const Camera& camera, int count,
                        Random& random, bool in_reach = true) {
  const auto accelerator = make_accelerator("zbuffer", world, holes);
  const auto oracle = make_accelerator("brute-force", world, holes);
  accelerator->prepare_view(camera, k_width, k_height);
  TraversalCost cost;
  int hits = 0;
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    const Ray ray = camera_ray(random, camera);
    const auto expected = oracle->closest_hit(ray);
    EXPECT_EQ(accelerator->closest_hit_counted(ray, cost), expected) << "ray " << i;
    EXPECT_EQ(accelerator->closest_hit(ray), expected) << "ray " << i;
    EXPECT_EQ(accelerator->any_hit(ray), expected.has_value()) << "ray " << i;
    if (expected) ++hits;
  }
  if (!::testing::Test::HasFailure() && in_reach) {
    EXPECT_EQ(cost.nodes, static_cast<std::size_t>(count));
  }
  return hits;
}

TEST(ZBuffer, MixedWorlds_AreSeenAsByRays) {
  Random random(1);
  int hits = 0;
  for (int round = 0; round < test::cases(40) && !HasFailure(); ++round) {
    const World world = test::mixed_world(random);
    SCOPED_TRACE(round);
    hits += expect_same_picture(world, nullptr, random_camera(random), 800, random);
  }
  EXPECT_GT(hits, test::cases(10000));
}

TEST(ZBuffer, MixedWorlds_AreMetByAnyOtherRayToo) {
  test::expect_agreement_in_mixed_worlds("zbuffer");
}

TEST(ZBuffer, TiedWorlds_ShowTheLowestIdentity) {
  Random random(2);
  int hits = 0;
  for (int round = 0; round < test::cases(40) && !HasFailure(); ++round) {
    const World world = test::tied_world(random);
    Camera camera = random_camera(random);
    if (random.below(2) == 0) camera = look_at({0.5f, 0.5f, 9.0f}, {0.5f, 0.5f, 0.0f}, 0.8f);
    hits += expect_same_picture(world, nullptr, camera, 800, random);
  }
  EXPECT_GT(hits, test::cases(3000));
}

TEST(ZBuffer, Holes_ShowWhatIsBehind) {
  Random random(3);
  const test::HalfHoles holes;
  int hits = 0;
  for (int round = 0; round < test::cases(30) && !HasFailure(); ++round) {
    World world = test::mixed_world(random);
    for (Object& object : world.objects) object.geometries[0].has_holes = true;
    hits += expect_same_picture(world, &holes, random_camera(random), 800, random);
  }
  EXPECT_GT(hits, test::cases(4000));
}

TEST(ZBuffer, HardMeshes_AreSeenAsByRays) {
  constexpr int k_rounds = LUME_SANITIZED ? 1 : 5;
  Random random(4);
  for (const test::HardMesh& hard : test::hard_meshes(random)) {
    SCOPED_TRACE(hard.name);
    World world;
    test::add_instance(world, hard.mesh);
    for (int round = 0; round < k_rounds && !HasFailure(); ++round) {
      const float size = hard.reach / 12.0f;
      const Camera camera = random_camera(random, hard.middle, size);
      expect_same_picture(world, nullptr, camera, test::cases(600), random, hard.reach < 1e15f);
    }
  }
}

/// Large triangles around the camera and through it, and small ones in between.
World closed_in(Random& random) {
  World world;
  test::add_instance(world, test::triangle_soup(random, 60, 5.0f, 20.0f));
  test::add_instance(world, test::triangle_soup(random, 300, 5.0f, 0.3f));
  test::add_instance(world, test::sphere_mesh(12), glm::scale(DMat4(1.0), DVec3(9.0)));
  return world;
}

TEST(ZBuffer, CameraAmongTriangles_SeesThoseBeforeIt) {
  Random random(5);
  int hits = 0;
  for (int round = 0; round < test::cases(40) && !HasFailure(); ++round) {
    const World world = closed_in(random);
    hits += expect_same_picture(world, nullptr, random_camera(random), 500, random);
  }
  EXPECT_GT(hits, test::cases(15000));
}

TEST(ZBuffer, TrianglesOfLessThanAPixel_AreSeenAsByRays) {
  Random random(6);
  int hits = 0;
  for (int round = 0; round < test::cases(10) && !HasFailure(); ++round) {
    World world;
    test::add_instance(world, test::sphere_mesh(60));  // 14,160 triangles in some 700 pixels
    Mesh needles = test::triangle_soup(random, 1000, 2.0f, 1.0f);
    for (std::size_t i = 0; i < needles.positions.size(); i += 3) {
      needles.positions[i + 1] = needles.positions[i] + random.cube(1e-4f);
    }
    test::add_instance(world, needles);
    const Camera camera = look_at(4.0f * random.direction(), random.cube(0.5f), 0.8f);
    hits += expect_same_picture(world, nullptr, camera, 300, random);
  }
  EXPECT_GT(hits, test::cases(300));
}

TEST(ZBuffer, ManyInstances_AreSeenAsByRays) {
  Random random(7);
  World world;
  world.objects.push_back({"", {{test::sphere_mesh(3)}, {Shape(Sphere{0.5})}}});
  for (int i = 0; i < 1000; ++i) {
    world.instances.push_back({"", 0, Transform(test::random_transform(random, 60.0f))});
  }
  int hits = 0;
  for (int round = 0; round < 4 && !HasFailure(); ++round) {
    hits += expect_same_picture(world, nullptr, random_camera(random), 300, random);
  }
  EXPECT_GT(hits, test::cases(100));
}

TEST(ZBuffer, OtherRays_GoTheirOwnWay) {
  World world;
  test::add_instance(world, test::square_mesh());
  const auto accelerator = make_accelerator("zbuffer", world, nullptr);
  const Camera camera = look_at({0, 0, 2}, {0, 0, 0}, 0.8f);
  const auto nodes_of = [&](const Ray& ray) {
    TraversalCost cost;
    EXPECT_TRUE(accelerator->closest_hit_counted(ray, cost));
    EXPECT_TRUE(accelerator->any_hit(ray));
    return cost.nodes;
  };
  const Ray ray = camera.generate_ray({0.49f, 0.48f}, 1.6f);
  EXPECT_EQ(nodes_of(ray), 0u);  // two hierarchies of one leaf each: no view yet
  accelerator->prepare_view(camera, k_width, k_height);
  EXPECT_EQ(nodes_of(ray), 1u);
  Ray other = ray;
  other.t_min = 0.1f;
  EXPECT_EQ(nodes_of(other), 0u);
  other = ray;
  other.origin.x += 1e-6f;
  EXPECT_EQ(nodes_of(other), 0u);
  // A view that cannot be drawn is forgotten, and the one before it too.
  accelerator->prepare_view(camera, 0, 0);
  EXPECT_EQ(nodes_of(ray), 0u);
  accelerator->prepare_view(camera, k_width, k_height);
  Camera thin_lens = camera;
  thin_lens.lens_radius = 0.1f;
  accelerator->prepare_view(thin_lens, k_width, k_height);
  EXPECT_EQ(nodes_of(ray), 0u);
}

TEST(ZBuffer, HiddenTriangles_AreLeftOut) {
  // A wall, and a hundred squares behind it: cells that the wall covers hold nothing else.
  World world;
  test::add_instance(world, test::square_mesh(50.0f));
  for (int i = 1; i <= 100; ++i) {
    const DMat4 matrix = glm::translate(DMat4(1.0), DVec3(0.0, 0.0, -0.1 * i));
    world.instances.push_back({"", 0, Transform(matrix)});
  }
  for (const bool is_perspective : {true, false}) {
    Camera camera = look_at({0, 0, 2}, {0, 0, 0}, 0.8f);
    if (!is_perspective) camera.projection = Camera::Projection::orthographic;
    const zbuffer::SceneItems items(world);
    const zbuffer::View view(camera, k_width, k_height);
    const auto raster = zbuffer::Raster::draw(items, view);
    ASSERT_TRUE(raster);
    EXPECT_EQ(raster->candidates({10, 20}).size(), 1u);
    // Only in cells on the wall's diagonal neither of its triangles covers all.
    const StructureStats stats = raster->stats();
    const std::size_t cells = std::size_t{k_width + 8} * (k_height + 8);
    EXPECT_EQ(stats.nodes, cells);
    EXPECT_EQ(stats.leaves, cells);
    EXPECT_LT(stats.references, cells + 250 * 202);
    EXPECT_GT(stats.memory_bytes, 8 * stats.references);
  }
}

TEST(ZBuffer, NumberOfThreads_ChangesNothing) {
  Random random(8);
  World world;
  test::add_instance(world, test::triangle_soup(random, 20000, 5.0f, 0.3f));
  const zbuffer::SceneItems items(world);
  const zbuffer::View view(look_at({0, 1, 9}, {0, 0, 0}, 0.8f), k_width, k_height);
  std::vector<std::vector<std::uint32_t>> candidates;
  for (const unsigned threads : {1u, 2u, 7u}) {
    const ThreadLimit limit(threads);
    const auto raster = zbuffer::Raster::draw(items, view);
    ASSERT_TRUE(raster);
    std::vector<std::uint32_t>& list = candidates.emplace_back();
    for (int y = 0; y < view.size().y; ++y) {
      for (int x = 0; x < view.size().x; ++x) {
        for (const zbuffer::Candidate& candidate : raster->candidates({x, y})) {
          list.push_back(candidate.item);
        }
      }
    }
  }
  EXPECT_GT(candidates[0].size(), 5000u);
  EXPECT_EQ(candidates[0], candidates[1]);
  EXPECT_EQ(candidates[0], candidates[2]);
}

TEST(ZBuffer, TooManyEntries_AreRefused) {
  Random random(9);
  World world;
  test::add_instance(world, test::triangle_soup(random, 20000, 5.0f, 0.3f));
  const zbuffer::SceneItems items(world);
  const zbuffer::View view(look_at({0, 1, 9}, {0, 0, 0}, 0.8f), k_width, k_height);
  const auto all = zbuffer::TileLists::sort(items, view, 1000000);
  ASSERT_TRUE(all);
  std::size_t count = 0;
  for (std::size_t i = 0; i < zbuffer::TileGrid(view).count(); ++i) count += all->items(i).size();
  EXPECT_GT(count, 10000u);
  EXPECT_TRUE(zbuffer::TileLists::sort(items, view, count));
  EXPECT_FALSE(zbuffer::TileLists::sort(items, view, count - 1));
}

}  // namespace
}  // namespace lume::geometry
