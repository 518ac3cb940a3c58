// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface_point.h"

#include "geometry/accelerators/accelerator.h"
#include "tests/support/random.h"
#include "tests/support/worlds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::geometry {
namespace {

using test::Random;

SurfacePoint meet(const World& world, const Accelerator& accelerator, const Ray& ray) {
  const auto hit = accelerator.closest_hit(ray);
  EXPECT_TRUE(hit.has_value());
  return surface_point(world, ray, *hit, refine(world, ray, *hit, nullptr));
}

TEST(SurfacePoint, SphereUnderRandomTransforms_HasTheQuadricsPointAndNormal) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    World world;
    const DMat4 matrix = test::random_transform(random);
    test::add_instance(world, test::sphere_mesh(64), matrix);
    const auto accelerator = make_accelerator("embree", world, nullptr);
    const Transform& transform = world.instances[0].transform;
    const Vec3 target(transform.point_to_world(DVec3(random.cube(0.3f))));
    const Ray ray{.origin = target + 100.0f * random.direction(), .direction = {}};
    const Ray aimed{.origin = ray.origin, .direction = normalize(target - ray.origin)};
    const SurfacePoint point = meet(world, *accelerator, aimed);
    // In object space the point's distance from the centre is 1, less the facets' sagitta.
    const DVec3 object_point = transform.point_to_object(DVec3(point.position));
    ASSERT_NEAR(length(object_point), 1.0, 2e-3);
    const DVec3 normal = normalize(transform.normal_to_world(object_point));
    ASSERT_GT(dot(Vec3(normal), point.normal), 0.9999f);
    ASSERT_GT(dot(Vec3(normal), point.geometric_normal), 0.95f);
    ASSERT_TRUE(point.front_facing);
    ASSERT_NEAR(length(point.position - aimed.origin), point.t, 1e-3f);
  }
}

TEST(SurfacePoint, RaysThatLeave_NeverMeetTheirOwnFlatSurface) {
  // A flat grid of many triangles, tilted, scaled and far from the origin: grazing rays that leave
  // it must meet neither their own triangle nor a coplanar neighbour.
  Random random(2);
  Mesh grid;
  constexpr std::uint32_t k_size = 20;
  for (std::uint32_t y = 0; y <= k_size; ++y) {
    for (std::uint32_t x = 0; x <= k_size; ++x) {
      grid.positions.emplace_back(static_cast<float>(x) / k_size - 0.5f,
                                  static_cast<float>(y) / k_size - 0.5f, 0.0f);
    }
  }
  for (std::uint32_t y = 0; y < k_size; ++y) {
    for (std::uint32_t x = 0; x < k_size; ++x) {
      const std::uint32_t a = y * (k_size + 1) + x;
      grid.triangles.emplace_back(a, a + 1, a + k_size + 2);
      grid.triangles.emplace_back(a, a + k_size + 2, a + k_size + 1);
    }
  }
  int rays = 0;
  for (int round = 0; round < 50; ++round) {
    World world;
    const float reach = std::exp2(random.uniform(0.0f, 14.0f));
    test::add_instance(world, grid, test::random_transform(random, reach));
    const auto accelerator = make_accelerator("embree", world, nullptr);
    const Transform& transform = world.instances[0].transform;
    for (int i = 0; i < 200; ++i) {
      const Vec3 target(transform.point_to_world(
          {random.uniform(-0.5f, 0.5f), random.uniform(-0.5f, 0.5f), 0.0}));
      const Ray ray{.origin = target + random.direction() * reach, .direction = {}};
      const Ray aimed{.origin = ray.origin, .direction = target - ray.origin};
      const auto hit = accelerator->closest_hit(aimed);
      if (!hit) continue;  // the aim is rounded: it may pass beside the rim
      const SurfacePoint point =
          surface_point(world, aimed, *hit, refine(world, aimed, *hit, nullptr));
      ASSERT_GT(point.offset, 0.0f);
      ASSERT_LT(point.offset, 1e-4f * reach + 1e-4f);
      const Ray away = leave(point, random.direction());
      ASSERT_FALSE(accelerator->any_hit(away)) << "round " << round << " ray " << i;
      ++rays;
    }
  }
  EXPECT_GT(rays, 5000);
}

TEST(SurfacePoint, LiftedShadowOrigin_LiesBetweenTheFacetAndTheSphere) {
  Random random(3);
  World world;
  test::add_instance(world, test::sphere_mesh(12));
  const auto accelerator = make_accelerator("embree", world, nullptr);
  int lifted = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 outward = random.direction();
    SurfacePoint point =
        meet(world, *accelerator, {.origin = 3.0f * outward, .direction = -outward});
    ASSERT_EQ(point.shadow_origin, point.position);
    lift_shadow_origin(world, point);
    const float before = length(point.position);
    const float after = length(point.shadow_origin);
    ASSERT_GE(after, before - 1e-6f);
    ASSERT_LT(after, 1.03f);
    if (after > before + 1e-4f) ++lifted;
  }
  EXPECT_GT(lifted, 800);
}

TEST(SurfacePoint, BackFace_IsToldApartAlsoUnderMirroring) {
  for (const double mirror : {1.0, -1.0}) {
    World world;
    DMat4 matrix(1.0);
    matrix[0][0] = mirror;
    test::add_instance(world, test::square_mesh(), matrix);
    const auto accelerator = make_accelerator("embree", world, nullptr);
    const SurfacePoint front =
        meet(world, *accelerator, {.origin = {0.1f, 0.2f, 1}, .direction = {0, 0, -1}});
    EXPECT_TRUE(front.front_facing);
    EXPECT_EQ(front.geometric_normal, Vec3(0, 0, 1));
    const SurfacePoint back =
        meet(world, *accelerator, {.origin = {0.1f, 0.2f, -1}, .direction = {0, 0, 1}});
    EXPECT_FALSE(back.front_facing);
    EXPECT_EQ(back.geometric_normal, Vec3(0, 0, 1));
  }
}

TEST(SurfacePoint, Attributes_AreInterpolatedAndDefault) {
  World world;
  Mesh mesh = test::square_mesh();
  mesh.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 0}};
  test::add_instance(world, mesh);
  const auto accelerator = make_accelerator("embree", world, nullptr);
  const SurfacePoint point =
      meet(world, *accelerator, {.origin = {0.25f, -0.125f, 1}, .direction = {0, 0, -1}});
  EXPECT_NEAR(point.texcoord(0).x, 0.75f, 1e-6f);
  EXPECT_NEAR(point.texcoord(0).y, 0.625f, 1e-6f);
  EXPECT_EQ(point.texcoord(7), Vec2(0.0f));
  EXPECT_NEAR(point.color().x + point.color().y + point.color().z, 1.0f, 1e-6f);
  test::mesh_of(world).colors.clear();
  EXPECT_EQ(point.color(), Vec4(1.0f));
}

void expect_frame(const Frame& frame, const Vec3& tangent, const Vec3& bitangent) {
  EXPECT_LT(length(frame.tangent - tangent), 1e-5f);
  EXPECT_LT(length(frame.bitangent - bitangent), 1e-5f);
}

TEST(TangentFrame, TextureCoordinates_PointRightAndUpInTheImage) {
  for (const double mirror : {1.0, -1.0}) {
    World world;
    DMat4 matrix(1.0);
    matrix[0][0] = mirror;
    test::add_instance(world, test::square_mesh(), matrix);
    const auto accelerator = make_accelerator("embree", world, nullptr);
    const SurfacePoint point =
        meet(world, *accelerator, {.origin = {0.1f, 0.2f, 1}, .direction = {0, 0, -1}});
    expect_frame(tangent_frame(world, point, 0), Vec3(static_cast<float>(mirror), 0, 0),
                 Vec3(0, 1, 0));
    // The same from given tangents, whose handedness is that of the unmirrored mesh.
    Mesh& mesh = test::mesh_of(world);
    mesh.normals.assign(4, Vec3(0, 0, 1));
    mesh.tangents.assign(4, Vec4(1, 0, 0, 1));
    expect_frame(tangent_frame(world, point, 0), Vec3(static_cast<float>(mirror), 0, 0),
                 Vec3(0, 1, 0));
  }
}

TEST(TangentFrame, MirroredTextureCoordinates_TurnTheTangentOnly) {
  World world;
  Mesh mesh = test::square_mesh();
  for (Vec2& uv : mesh.texcoords[0]) uv.x = 1.0f - uv.x;
  test::add_instance(world, mesh);
  const auto accelerator = make_accelerator("embree", world, nullptr);
  const SurfacePoint point =
      meet(world, *accelerator, {.origin = {0.1f, 0.2f, 1}, .direction = {0, 0, -1}});
  expect_frame(tangent_frame(world, point, 0), {-1, 0, 0}, {0, 1, 0});
}

TEST(TangentFrame, TurnedTexture_TurnsTheFrameAlong) {
  World world;
  test::add_instance(world, test::square_mesh());
  const auto accelerator = make_accelerator("embree", world, nullptr);
  const SurfacePoint point =
      meet(world, *accelerator, {.origin = {0.1f, 0.2f, 1}, .direction = {0, 0, -1}});
  // u' = v, v' = -u: the image's right runs down the square and its top to the right.
  expect_frame(tangent_frame(world, point, 0, glm::mat2(0, -1, 1, 0)), {0, -1, 0}, {1, 0, 0});
  expect_frame(tangent_frame(world, point, 0, glm::mat2(3, 0, 0, 2)), {1, 0, 0}, {0, 1, 0});
}

TEST(TangentFrame, NoCoordinates_GiveSomeOrthonormalFrame) {
  World world;
  Mesh mesh = test::square_mesh();
  mesh.texcoords.clear();
  test::add_instance(world, mesh);
  const auto accelerator = make_accelerator("embree", world, nullptr);
  const SurfacePoint point =
      meet(world, *accelerator, {.origin = {0.1f, 0.2f, 1}, .direction = {0, 0, -1}});
  const Frame frame = tangent_frame(world, point, 0);
  EXPECT_NEAR(length(frame.tangent), 1.0f, 1e-6f);
  EXPECT_NEAR(dot(cross(frame.tangent, frame.bitangent), frame.normal), 1.0f, 1e-6f);
}

TEST(ShadowRay, ToALight_EndsJustBeforeIt) {
  World world;
  test::add_instance(world, test::square_mesh());
  DMat4 up(1.0);
  up[3] = glm::dvec4(0, 0, 2, 1);
  test::add_instance(world, test::square_mesh(), up);
  const auto accelerator = make_accelerator("embree", world, nullptr);
  const SurfacePoint point =
      meet(world, *accelerator, {.origin = {0.1f, 0.2f, 1}, .direction = {0, 0, -1}});
  EXPECT_FALSE(accelerator->any_hit(shadow_ray(point, {0.1f, 0.1f, 2.0f})));
  EXPECT_TRUE(accelerator->any_hit(shadow_ray(point, {0.1f, 0.1f, 2.1f})));
  EXPECT_TRUE(accelerator->any_hit(shadow_ray_along(point, {0, 0, 1})));
}

TEST(MakeFrame, RandomNormals_GiveOrthonormalRightHandedFrames) {
  Random random(5);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 n = random.direction();
    const Frame frame = make_frame(n);
    ASSERT_LT(length(cross(frame.tangent, frame.bitangent) - n), 1e-5f);
    ASSERT_NEAR(dot(frame.tangent, n), 0.0f, 1e-6f);
    const Vec3 v = random.cube(2.0f);
    ASSERT_LT(length(frame.to_world(frame.to_local(v)) - v), 1e-5f);
  }
  const Frame down = make_frame({0, 0, -1});
  EXPECT_LT(length(cross(down.tangent, down.bitangent) - Vec3(0, 0, -1)), 1e-6f);
}

}  // namespace
}  // namespace lume::geometry
