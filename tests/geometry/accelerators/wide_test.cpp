// SPDX-License-Identifier: Apache-2.0
// The wide tree: that every kernel names what brute force names, and that its builder loses
// nothing.
#include "geometry/accelerators/wide/builder.h"
#include "geometry/accelerators/wide/query.h"
#include "geometry/parallel.h"
#include "geometry/shapes/triangle.h"
#include "tests/support/agreement.h"
#include "tests/support/cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

namespace lume::geometry {
namespace {

using test::Random;
using wide::Child;
using wide::Kernel;
using wide::Tree;

/// Those that this processor can run.
std::vector<const Kernel*> kernels() {
  std::vector<const Kernel*> result = {&wide::k_scalar_kernel};
  if (wide::can_run(wide::k_avx2_kernel)) result.push_back(&wide::k_avx2_kernel);
  if (wide::can_run(wide::k_avx512_kernel)) result.push_back(&wide::k_avx512_kernel);
  return result;
}

Object object_of(Mesh mesh) {
  Object object;
  object.geometries.push_back({std::move(mesh)});
  return object;
}

wide::TriangleQuery query_of(const Ray& ray) {
  wide::TriangleQuery query;
  query.ray = {{ray.origin.x, ray.origin.y, ray.origin.z},
               {ray.direction.x, ray.direction.y, ray.direction.z},
               ray.t_min,
               ray.t_max};
  return query;
}

/// The lowest of the nearest items, and its t.
std::pair<std::uint32_t, double> nearest_item(const TriangleItems& items, const Ray& ray) {
  const ShearedRay sheared(DVec3(ray.origin), DVec3(ray.direction));
  std::pair<std::uint32_t, double> best{wide::k_no_item, ray.t_max};
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    const auto corners = items.corners(i);
    const TriangleCrossing crossing =
        intersect_triangle(sheared, DVec3(corners[0]), DVec3(corners[1]), DVec3(corners[2]));
    if (!crossing.inside || !(crossing.t >= ray.t_min)) continue;
    const bool is_first = best.first == wide::k_no_item && crossing.t == best.second;
    if (crossing.t < best.second || is_first) best = {i, crossing.t};
  }
  return best;
}

/// Rays through every kernel: the same triangle, at the same t to the last bit.
template <class MakeRay>
void expect_nearest(const TriangleItems& items, int count, const MakeRay& make_ray) {
  const Tree tree = wide::build_tree(items);
  int hits = 0;
  for (int i = 0; i < count; ++i) {
    const Ray ray = make_ray();
    const auto [item, t] = nearest_item(items, ray);
    hits += item != wide::k_no_item ? 1 : 0;
    for (const Kernel* kernel : kernels()) {
      wide::TriangleQuery query = query_of(ray);
      kernel->closest(tree, query);
      ASSERT_EQ(query.item, item) << kernel->name << ", ray " << i;
      ASSERT_EQ(query.ray.t_max, item != wide::k_no_item ? t : query_of(ray).ray.t_max)
          << kernel->name << ", ray " << i;
      wide::TriangleQuery any = query_of(ray);
      ASSERT_EQ(kernel->any(tree, any), item != wide::k_no_item) << kernel->name << ", ray " << i;
    }
  }
  EXPECT_GE(hits, items.size() > 10 ? count / 500 : 0);
}

TEST(WideKernels, RandomSoup_NearestTriangleAsByBruteForce) {
  Random random(1);
  for (const std::size_t size : {1u, 3u, 5u, 40u, 2000u}) {
    const Object object = object_of(test::triangle_soup(random, size, 4.0f, 1.0f));
    expect_nearest(TriangleItems(object), test::cases(4000),
                   [&] { return test::random_ray(random); });
  }
}

TEST(WideKernels, AxisParallelRaysOnAGrid_NearestTriangleAsByBruteForce) {
  Random random(2);
  Mesh mesh = test::square_mesh();
  const std::vector<Vec3> square = mesh.positions;
  for (int i = 0; i < 200; ++i) {
    const Vec3 offset = glm::round(random.cube(5.0f));
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec3& p : square) mesh.positions.push_back(p + offset);
    mesh.triangles.emplace_back(first, first + 1, first + 2);
    mesh.triangles.emplace_back(first, first + 2, first + 3);
  }
  const Object object = object_of(mesh);
  expect_nearest(TriangleItems(object), test::cases(10000), [&] { return test::axis_ray(random); });
}

/// A closed mesh with shared corners.
Object closed_sphere(const Vec3& center) {
  Mesh mesh = test::sphere_mesh(24);
  for (Vec3& p : mesh.positions) p += center;
  return object_of(mesh);
}

TEST(WideKernels, RaysAtEdgesAndCornersOfAClosedMesh_NeverSlipThrough) {
  Random random(3);
  for (const Vec3 center : {Vec3(0.0f), Vec3(1000.0f, -300.0f, 77.0f)}) {
    const Object object = closed_sphere(center);
    const Mesh& mesh = *object.geometries[0].mesh();
    const Tree tree = wide::build_tree(TriangleItems(object));
    for (int i = 0; i < test::cases(50000); ++i) {
      const UVec3& corners =
          mesh.triangles[random.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
      const float along = i % 3 == 0 ? 0.0f : random.uniform();
      const Vec3 aim =
          mesh.positions[corners.x] * (1.0f - along) + mesh.positions[corners.y] * along;
      const Vec3 origin = center + random.cube(0.4f);
      for (const Kernel* kernel : kernels()) {
        wide::TriangleQuery query = query_of({.origin = origin, .direction = aim - origin});
        ASSERT_TRUE(kernel->any(tree, query)) << kernel->name << ", ray " << i;
        kernel->closest(tree, query);
        ASSERT_NE(query.item, wide::k_no_item) << kernel->name << ", ray " << i;
      }
    }
  }
}

/// Packets of rays from one place, of which some run in other octants, some are not there, and some
/// end early: each ray has the answer that it has alone.
TEST(WideKernels, PacketsOfRays_MeetWhatEachMeetsAlone) {
  Random random(8);
  const Object object = object_of(test::triangle_soup(random, 3000, 4.0f, 0.4f));
  const Tree tree = wide::build_tree(TriangleItems(object));
  int hits = 0;
  for (int i = 0; i < test::cases(3000); ++i) {
    const Vec3 eye = random.cube(8.0f);
    const Vec3 aim = random.cube(3.0f);
    const float spread = i % 4 == 0 ? 5.0f : 0.3f;
    std::vector<Ray> rays(1 + random.below(wide::k_packet_size));
    for (Ray& ray : rays) {
      ray.origin = eye;
      ray.direction = aim + random.cube(spread) - eye;
      if (random.below(4) == 0) ray.t_max = random.uniform(0.2f, 1.2f);
    }
    const auto count = static_cast<unsigned>(rays.size());
    for (const Kernel* kernel : kernels()) {
      std::vector<wide::TriangleQuery> closest;
      for (const Ray& ray : rays) closest.push_back(query_of(ray));
      std::vector<wide::TriangleQuery> any = closest;
      kernel->closest_of_packet(tree, closest.data(), count);
      const unsigned met = kernel->any_of_packet(tree, any.data(), count);
      for (unsigned k = 0; k < count; ++k) {
        wide::TriangleQuery alone = query_of(rays[k]);
        kernel->closest(tree, alone);
        hits += alone.item != wide::k_no_item ? 1 : 0;
        ASSERT_EQ(closest[k].item, alone.item) << kernel->name << ", packet " << i;
        ASSERT_EQ(closest[k].ray.t_max, alone.ray.t_max) << kernel->name << ", packet " << i;
        ASSERT_EQ((met >> k & 1u) != 0, alone.item != wide::k_no_item) << kernel->name;
      }
    }
  }
  EXPECT_GT(hits, test::cases(10000));
}

void expect_same_in_batches(Random& random, const World& world) {
  for (const std::string_view name : {"wide", "embree", "embree-high", "bvh-sah"}) {
    for (const bool native : {false, true}) {
      const auto accelerator = make_accelerator(name, world, nullptr, {native});
      std::vector<Ray> rays(100);
      for (Ray& ray : rays) ray = test::random_ray(random);
      rays[7].origin.x = std::numeric_limits<float>::quiet_NaN();
      std::vector<std::optional<Hit>> hits(rays.size(), Hit{9, 9, 9});
      std::vector<std::uint8_t> occluded(rays.size(), 7);
      accelerator->closest_hits(rays, hits);
      accelerator->any_hits(rays, occluded);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(hits[i], accelerator->closest_hit(rays[i])) << name;
        ASSERT_EQ(occluded[i] != 0, accelerator->any_hit(rays[i])) << name;
      }
    }
  }
}

TEST(Wide, BatchesOfRays_AreAnsweredAsOneByOne) {
  Random random(9);
  expect_same_in_batches(random, test::mixed_world(random));
  World triangles;  // where Embree takes packets
  test::add_instance(triangles, test::triangle_soup(random, 500, 4.0f, 1.0f));
  test::add_instance(triangles, test::triangle_soup(random, 500, 1.0f, 1.0f),
                     test::random_transform(random, 3.0f));
  expect_same_in_batches(random, triangles);
}

TEST(Wide, WorldsOfEveryKind_AgreeWithBruteForce) {
  Random random(4);
  int hits = 0;
  for (int round = 0; round < 10; ++round) {
    const World mixed = test::mixed_world(random);
    hits += test::expect_agreement("wide", mixed, nullptr, test::cases(3000),
                                   [&] { return test::random_ray(random); });
    const World tied = test::tied_world(random);
    hits += test::expect_agreement("wide", tied, nullptr, test::cases(2000),
                                   [&] { return test::axis_ray(random); });
    hits += test::expect_agreement("wide", tied, nullptr, test::cases(2000),
                                   [&] { return test::random_ray(random); });
  }
  EXPECT_GT(hits, test::cases(10000));
}

/// The leaves, with the box that the way to each has left of space.
template <class Visit>
void visit_leaves(const Tree& tree, std::uint32_t child, const Bounds& box, std::size_t depth,
                  const Visit& visit) {
  ASSERT_LE(depth, wide::k_max_depth);
  if (Child::is_leaf(child)) {
    visit(Child::first(child), Child::count(child), box);
    return;
  }
  const wide::Node& node = tree.nodes[child];
  for (std::size_t lane = 0; lane < wide::k_width; ++lane) {
    Bounds part;
    for (int axis = 0; axis < 3; ++axis) {
      part.lower[axis] = std::max(box.lower[axis], node.planes[2 * axis][lane]);
      part.upper[axis] = std::min(box.upper[axis], node.planes[2 * axis + 1][lane]);
    }
    if (!part.is_empty()) visit_leaves(tree, node.child[lane], part, depth + 1, visit);
  }
}

const Bounds k_all_space{Vec3(-std::numeric_limits<float>::infinity()),
                         Vec3(std::numeric_limits<float>::infinity())};

/// Small triangles, and among them long thin ones in all directions, which are worth cutting.
Mesh sticks(Random& random, std::size_t count) {
  Mesh mesh = test::triangle_soup(random, count - count / 10, 5.0f, 0.05f);
  for (std::size_t i = 0; i < count / 10; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const Vec3 from = random.cube(5.0f);
    mesh.positions.push_back(from);
    mesh.positions.push_back(from + 8.0f * random.direction());
    mesh.positions.push_back(from + 0.05f * random.direction());
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  return mesh;
}

TEST(WideBuilder, EveryPointOfATriangle_IsInALeafThatHasTheTriangle) {
  Random random(5);
  const Object object = object_of(sticks(random, 5000));
  const TriangleItems items(object);
  const Tree tree = wide::build_tree(items);
  struct Leaf {
    Bounds box;
    std::set<std::uint32_t> items;
  };
  std::vector<Leaf> leaves;
  std::size_t references = 0;
  visit_leaves(tree, tree.root, k_all_space, 0,
               [&](std::uint32_t first, std::uint32_t count, const Bounds& box) {
                 Leaf& leaf = leaves.emplace_back();
                 leaf.box = box;
                 for (std::uint32_t i = first; i < first + count; ++i) {
                   for (std::size_t lane = 0; lane < wide::TriangleBlock::k_size; ++lane) {
                     const wide::TriangleBlock& block = tree.blocks[i];
                     if (std::isnan(block.corner[0][0][lane])) continue;
                     leaf.items.insert(block.item[lane]);
                   }
                 }
                 references += leaf.items.size();
               });
  EXPECT_GT(references, items.size() * 105 / 100) << "hardly anything was cut";
  EXPECT_LE(references, items.size() * 13 / 10);
  EXPECT_EQ(references, tree.reference_count);
  EXPECT_EQ(leaves.size(), tree.leaf_count);
  for (int i = 0; i < test::cases(3000); ++i) {
    const std::uint32_t item = random.below(items.size());
    const auto corners = items.corners(item);
    float u = random.uniform();
    float v = random.uniform();
    if (u + v > 1.0f) {
      u = 1.0f - u;
      v = 1.0f - v;
    }
    const Vec3 point = corners[0] * (1.0f - u - v) + corners[1] * u + corners[2] * v;
    // The point itself is rounded.
    ASSERT_TRUE(std::any_of(leaves.begin(), leaves.end(),
                            [&](const Leaf& leaf) {
                              const Bounds wider{leaf.box.lower - 2e-6f, leaf.box.upper + 2e-6f};
                              return leaf.items.count(item) > 0 && wider.contains(point);
                            }))
        << "item " << item;
  }
}

TEST(WideBuilder, AnyNumberOfThreads_GivesTheSameTree) {
  Random random(6);
  const Object object = object_of(sticks(random, 30000));
  const TriangleItems items(object);
  std::vector<Tree> trees;
  for (const unsigned threads : {1u, 2u, 5u}) {
    const ThreadLimit limit(threads);
    trees.push_back(wide::build_tree(items));
  }
  for (std::size_t i = 1; i < trees.size(); ++i) {
    ASSERT_EQ(trees[i].nodes.size(), trees[0].nodes.size());
    ASSERT_EQ(trees[i].blocks.size(), trees[0].blocks.size());
    for (std::size_t n = 0; n < trees[0].nodes.size(); ++n) {
      ASSERT_TRUE(std::equal(trees[0].nodes[n].child, trees[0].nodes[n].child + wide::k_width,
                             trees[i].nodes[n].child));
    }
  }
}

TEST(WideBuilder, DegenerateInput_IsSurvivedAndMet) {
  Random random(7);
  const auto agree = [&random](Mesh mesh, float reach) {
    SCOPED_TRACE(mesh.triangles.size());
    const Object object = object_of(std::move(mesh));
    const TriangleItems items(object);
    const Tree tree = wide::build_tree(items);
    for (int i = 0; i < test::cases(500); ++i) {
      Ray ray = test::random_ray(random);
      ray.origin *= reach;
      ray.direction *= reach;
      const auto [item, t] = nearest_item(items, ray);
      for (const Kernel* kernel : kernels()) {
        wide::TriangleQuery query = query_of(ray);
        kernel->closest(tree, query);
        ASSERT_EQ(query.item, item) << kernel->name << " at " << reach << ", t " << t;
      }
    }
  };
  agree({}, 1.0f);
  // All in the same place.
  Mesh same = test::triangle_soup(random, 1, 1.0f, 3.0f);
  same.triangles.resize(3000, same.triangles[0]);
  agree(same, 1.0f);
  // Without area.
  Mesh flat = test::triangle_soup(random, 300, 2.0f, 1.0f);
  for (UVec3& triangle : flat.triangles) triangle.z = triangle.y;
  agree(flat, 1.0f);
  // Ever smaller towards one corner, as far as doubles can tell.
  Mesh shrinking;
  for (int i = 0; i < 2000; ++i) {
    const auto first = static_cast<std::uint32_t>(shrinking.positions.size());
    const float size = std::ldexp(1.0f, -(i % 40));
    for (const Vec3 corner : {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 0, 1)}) {
      shrinking.positions.push_back(corner * size);
    }
    shrinking.triangles.emplace_back(first, first + 1, first + 2);
  }
  agree(shrinking, 1.0f);
  for (const float size : {1e-20f, 1e6f, 1e15f, 3e16f}) {
    Mesh scaled = test::triangle_soup(random, 300, 4.0f, 1.0f);
    for (Vec3& p : scaled.positions) p *= size;
    agree(scaled, size);
  }
  // Larger than boxes can be, beside small ones.
  Mesh huge = test::triangle_soup(random, 300, 4.0f, 1.0f);
  for (int i = 0; i < 9; ++i) huge.positions[static_cast<std::size_t>(i)] *= 1e30f;
  agree(huge, 1.0f);
  // Far from the origin, and what is not finite is not there.
  Mesh far = test::triangle_soup(random, 300, 4.0f, 1.0f);
  for (Vec3& p : far.positions) p += Vec3(1e6f, -1e6f, 1e6f);
  far.positions[0].x = std::numeric_limits<float>::quiet_NaN();
  far.positions[4].y = std::numeric_limits<float>::infinity();
  agree(far, 1e6f);
}

}  // namespace
}  // namespace lume::geometry
