// SPDX-License-Identifier: Apache-2.0
// Shapes as parts of a world: under transforms, in every accelerator, with holes, and left again by
// rays that start on them.
#include "geometry/accelerators/accelerator.h"
#include "geometry/surface_point.h"
#include "tests/support/random.h"
#include "tests/support/worlds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::geometry {
namespace {

using test::Random;

/// One of each shape, of size 1 or so.
std::vector<Shape> all_shapes() {
  const DVec3 axes(0.9, 0.7, 0.8);
  const auto quadric = [&](QuadricForm form, bool caps) {
    return Quadric(quadric_matrix(form, axes, 0.4), -axes, axes, caps);
  };
  BezierPatch patch;
  for (std::size_t i = 0; i < 16; ++i) {
    const std::size_t row = i / 4;
    patch[i] = {static_cast<double>(i % 4) / 1.5 - 1.0, static_cast<double>(i % 3) * 0.5 - 0.4,
                static_cast<double>(row) / 1.5 - 1.0};
  }
  return {Plane{1.5, 1.0},
          Disk{1.0, 0.3},
          Box{{0.5, 0.8, 0.3}},
          Sphere{0.9},
          Cylinder{1.2, 0.7, 0.4},
          Capsule(1.0, 0.5, 0.3),
          quadric(QuadricForm::ellipsoid, false),
          quadric(QuadricForm::hyperboloid_one_sheet, true),
          quadric(QuadricForm::paraboloid, false),
          Polygon({{{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {0, 0, 0}, {1, 0, -1}}}),
          Torus{0.7, 0.25},
          ImplicitSurface(Expression("x^4 + y^4 + z^4 - 0.4"), DVec3(-1.0), DVec3(1.0)),
          BezierSurface({patch})};
}

/// Lone shapes, objects of several shapes, and objects of shapes and triangles, under random
/// transforms; planes without end among them.
World random_world(Random& random) {
  World world;
  const std::vector<Shape> shapes = all_shapes();
  for (const Shape& shape : shapes) {
    test::add_instance(world, shape, test::random_transform(random, 5.0f));
  }
  test::add_instance(world, Plane{}, test::random_transform(random, 5.0f));
  Object& mixed = world.objects.emplace_back();
  mixed.geometries.push_back({shapes[random.below(6)]});
  mixed.geometries.push_back({test::triangle_soup(random, 10, 1.0f, 0.5f)});
  mixed.geometries.push_back({shapes[6 + random.below(6)]});
  mixed.geometries.push_back({Shape(Plane{})});
  for (int i = 0; i < 3; ++i) {
    const auto object = static_cast<std::uint32_t>(world.objects.size() - 1);
    world.instances.push_back({"", object, Transform(test::random_transform(random, 5.0f))});
  }
  return world;
}

Ray random_ray(Random& random, float distance = 12.0f) {
  Ray ray{.origin = random.cube(distance), .direction = random.cube(8.0f)};
  ray.direction -= ray.origin;
  if (random.uniform() < 0.3f) ray.t_max = random.uniform(0.2f, 1.5f);
  return ray;
}

/// A chequered pattern of holes on every surface.
class Chequers final : public HoleTest {
 public:
  [[nodiscard]] bool is_hole(const Hit&, Vec2 uv) const override {
    const auto sum = static_cast<int>(std::floor(uv.x * 10.0f) + std::floor(uv.y * 10.0f));
    return sum % 2 != 0;
  }
};

bool is_triangle(const World& world, const std::optional<Hit>& hit) {
  return hit && world.geometry(*hit).mesh() != nullptr;
}

/// Shapes are met in double by the same numbers everywhere, so here every ray must agree; triangles
/// are Embree's, whose float may decide otherwise at their edges.
void expect_same_hits(Random& random, const World& world, const HoleTest* holes) {
  const auto embree = make_accelerator("embree", world, holes);
  const auto oracle = make_accelerator("brute-force", world, holes);
  int hits = 0;
  int at_triangles = 0;
  constexpr int k_rays = 2000;
  for (int i = 0; i < k_rays; ++i) {
    const Ray ray = random_ray(random, i % 4 == 0 ? 1e4f : 12.0f);
    const auto expected = oracle->closest_hit(ray);
    const auto found = embree->closest_hit(ray);
    hits += expected ? 1 : 0;
    if (found != expected && (is_triangle(world, found) || is_triangle(world, expected))) {
      ++at_triangles;
      continue;
    }
    ASSERT_EQ(found, expected) << "ray " << i;
    ASSERT_EQ(embree->any_hit(ray), expected.has_value()) << "ray " << i;
  }
  EXPECT_GT(hits, k_rays / 4);
  EXPECT_LE(at_triangles, 2);
}

TEST(ShapeWorld, EmbreeAndBruteForce_NameTheSameShapes) {
  Random random(1);
  for (int round = 0; round < 20; ++round) {
    expect_same_hits(random, random_world(random), nullptr);
  }
}

TEST(ShapeWorld, Holes_AreTheSameInEveryAccelerator) {
  Random random(2);
  const Chequers holes;
  for (int round = 0; round < 10; ++round) {
    World world = random_world(random);
    for (Object& object : world.objects) {
      for (Geometry& geometry : object.geometries) geometry.has_holes = geometry.shape() != nullptr;
    }
    expect_same_hits(random, world, &holes);
  }
}

TEST(ShapeWorld, HoleInFront_ShowsTheBackOfTheSameShape) {
  class NorthernHalf final : public HoleTest {
   public:
    [[nodiscard]] bool is_hole(const Hit&, Vec2 uv) const override { return uv.y < 0.5f; }
  };
  World world;
  test::add_instance(world, Sphere{1.0});
  world.objects[0].geometries[0].has_holes = true;
  const NorthernHalf holes;
  const Ray ray{.origin = {0, 4, 0.5f}, .direction = {0, -1, 0}};
  for (const std::string_view name : accelerator_names()) {
    const auto accelerator = make_accelerator(name, world, &holes);
    const auto hit = accelerator->closest_hit(ray);
    ASSERT_TRUE(hit) << name;
    EXPECT_NEAR(refine(world, ray, *hit, &holes).t, 4.0 + std::sqrt(0.75), 1e-12) << name;
    EXPECT_FALSE(accelerator->any_hit({.origin = {0, 4, 0}, .direction = {0, -1, 0}, .t_max = 4}));
  }
}

/// R' = T^-1 R, and N = (T^-1)^T N': against the cross product of transformed tangents.
TEST(ShapeWorld, TransformedShapes_HaveTheirPointOnTheRayAndTheNormalAcrossTheirTangents) {
  Random random(3);
  int compared = 0;
  for (int round = 0; round < 300; ++round) {
    for (const Shape& shape : all_shapes()) {
      World world;
      test::add_instance(world, shape, test::random_transform(random));
      const Vec3 target(world.instances[0].transform.point_to_world(DVec3(random.cube(0.5f))));
      const Vec3 origin = target + 30.0f * random.direction();
      const Ray ray{.origin = origin, .direction = target - origin};
      const auto accelerator = make_accelerator("embree", world, nullptr);
      const auto hit = accelerator->closest_hit(ray);
      if (!hit) continue;
      const SurfacePoint point = surface_point(world, ray, *hit, refine(world, ray, *hit, nullptr));
      ASSERT_LT(length(ray.origin + point.t * ray.direction - point.position), 2e-5f);
      const Vec3 normal = cross(point.dp_dv, point.dp_du);
      if (!(length(normal) > 1e-4f * length(point.dp_du) * length(point.dp_dv))) continue;
      const float mirrored =
          glm::determinant(world.instances[0].transform.linear()) < 0.0 ? -1.0f : 1.0f;
      ASSERT_LT(length(normalize(normal) * mirrored - point.geometric_normal), 1e-3f)
          << shape_name(shape) << " in round " << round;
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000);
}

/// Neither shadow acne nor a light leak: from every point of a convex solid a ray outwards meets
/// nothing, and a ray inwards meets the solid again, in front of the other side.
TEST(ShapeWorld, RaysThatLeaveAConvexSolid_DoNotMeetItsSkin) {
  Random random(4);
  const std::vector<Shape> solids = {
      Box{{0.5, 0.8, 0.3}}, Sphere{0.9}, Cylinder{1.2, 0.7, 0.4}, Capsule(1.0, 0.5, 0.3),
      Quadric(quadric_matrix(QuadricForm::ellipsoid, DVec3(0.7), 0.0), DVec3(-1.0), DVec3(1.0),
              false)};
  int left = 0;
  int lost = 0;
  for (int round = 0; round < 400; ++round) {
    const float reach = round % 2 == 0 ? 1.0f : 1000.0f;
    for (const Shape& shape : solids) {
      World world;
      test::add_instance(world, shape, test::random_transform(random, reach));
      const Transform& transform = world.instances[0].transform;
      const auto accelerator = make_accelerator("embree", world, nullptr);
      for (int i = 0; i < 20; ++i) {
        const Vec3 target(transform.point_to_world(DVec3(random.cube(0.2f))));
        const Vec3 origin = target + 50.0f * random.direction();
        const Ray ray{.origin = origin, .direction = target - origin};
        const auto hit = accelerator->closest_hit(ray);
        ASSERT_TRUE(hit);
        const SurfacePoint point =
            surface_point(world, ray, *hit, refine(world, ray, *hit, nullptr));
        const Vec3 any = random.direction();
        const float side = dot(any, point.geometric_normal) < 0.0f ? -1.0f : 1.0f;
        ASSERT_FALSE(accelerator->any_hit(leave(point, side * any)))
            << shape_name(shape) << " in round " << round;
        ASSERT_FALSE(accelerator->any_hit(shadow_ray_along(point, side * any)));
        // Inwards, but not so flat that the skin is the next thing to meet.
        if (std::abs(dot(any, point.geometric_normal)) < 0.2f) continue;
        const Ray inwards = leave(point, -side * any);
        const auto other_side = accelerator->closest_hit(inwards);
        ++left;
        if (!other_side) {
          ++lost;
          continue;
        }
        const SurfacePoint far = surface_point(world, inwards, *other_side,
                                               refine(world, inwards, *other_side, nullptr));
        ASSERT_TRUE(far.t > 10.0f * point.offset ||
                    dot(far.geometric_normal, point.geometric_normal) < 0.9f);
      }
    }
  }
  EXPECT_GT(left, 10000);
  EXPECT_LE(lost, left / 2000);  // so near to an edge that a float may lie beyond the next face
}

TEST(ShapeWorld, WorldBounds_LeaveOutWhatHasNoEnd) {
  World world;
  test::add_instance(world, Plane{});
  EXPECT_TRUE(world.bounds().is_empty());
  test::add_instance(world, Sphere{2.0});
  EXPECT_NEAR(world.bounds().upper.y, 2.0f, 1e-6f);
  // The plane is there all the same, as far as a ray can go.
  const auto accelerator = make_accelerator("embree", world, nullptr);
  const Ray down{.origin = {3e9f, 5, -2e8f}, .direction = {0, -1, 0}};
  EXPECT_EQ(accelerator->closest_hit(down), (Hit{0, 0, 0}));
  EXPECT_TRUE(accelerator->any_hit(down));
}

TEST(ShapeWorld, Bounds_AreThoseOfTheTurnedShape) {
  // A sphere turned by 45 degrees is no larger; the box around it would be.
  DMat4 turned(1.0);
  const double s = std::sqrt(0.5);
  turned[0] = {s, 0, -s, 0};
  turned[2] = {s, 0, s, 0};
  const Bounds bounds = shape_bounds(Sphere{1.0}, Transform(turned));
  EXPECT_NEAR(bounds.upper.x, 1.0f, 1e-6f);
  EXPECT_NEAR(bounds.lower.z, -1.0f, 1e-6f);
  const Bounds box = shape_bounds(Box{DVec3(1.0)}, Transform(turned));
  EXPECT_NEAR(box.upper.x, std::sqrt(2.0f), 1e-6f);
  EXPECT_NEAR(box.upper.y, 1.0f, 1e-6f);
}

}  // namespace
}  // namespace lume::geometry
