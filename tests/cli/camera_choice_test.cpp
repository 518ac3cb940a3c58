// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/camera_choice.h"

#include "renderer/cli/exit_codes.h"
#include "renderer/cli/picture.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <string>

namespace lume::cli {
namespace {

using geometry::Camera;
using geometry::DVec3;
using geometry::Vec3;

/// A unit cube's corners as a scene, with two cameras.
shading::Scene make_scene() {
  shading::Scene scene;
  geometry::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 2}};
  mesh.triangles = {{0, 1, 2}};
  scene.world.objects.resize(1);
  scene.world.objects[0].geometries.push_back({mesh});
  scene.world.instances.resize(1);
  scene.materials.resize(1);
  scene.cameras.resize(2);
  scene.cameras[0].name = "front";
  scene.cameras[1].name = "side";
  scene.cameras[1].projection = Camera::Projection::orthographic;
  return scene;
}

TEST(CameraChoice, NothingAsked_TakesTheFirstOfTheFile) {
  const shading::Scene scene = make_scene();
  EXPECT_EQ(find_file_camera(scene, {}), scene.cameras.data());
}

TEST(CameraChoice, NameOrNumber_FindsTheCamera) {
  const shading::Scene scene = make_scene();
  RenderOptions options;
  options.camera = "side";
  EXPECT_EQ(find_file_camera(scene, options), &scene.cameras[1]);
  options.camera = "1";
  EXPECT_EQ(find_file_camera(scene, options), &scene.cameras[1]);
}

TEST(CameraChoice, NumberThatIsAName_MeansTheName) {
  shading::Scene scene = make_scene();
  scene.cameras[0].name = "1";
  RenderOptions options;
  options.camera = "1";
  EXPECT_EQ(find_file_camera(scene, options), scene.cameras.data());
}

TEST(CameraChoice, Unknown_SuggestsTheNearest) {
  const shading::Scene scene = make_scene();
  RenderOptions options;
  for (const char* name : {"frnt", "2", "-1", "", "1 "}) {
    options.camera = name;
    EXPECT_THROW((void)find_file_camera(scene, options), UsageError) << name;
  }
  options.camera = "frnt";
  try {
    (void)find_file_camera(scene, options);
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "unknown camera 'frnt'; did you mean 'front'? (known: front, side)");
  }
}

TEST(CameraChoice, Orbit_StandsWhereTheFormulaSays) {
  shading::Scene scene = make_scene();
  scene.origin = {1000.0, 0.0, -500.0};
  RenderOptions options;
  options.orbit = DVec3(30.0, 60.0, 4.0);
  options.target = DVec3(1001.0, 2.0, -497.0);
  const CameraChoice choice = choose_camera(scene, options, nullptr, 1.5f);
  const double theta = std::numbers::pi / 6.0;
  const double phi = std::numbers::pi / 3.0;
  const Vec3 eye(DVec3(1.0, 2.0, 3.0) + 4.0 * DVec3(std::sin(phi) * std::sin(theta), std::cos(phi),
                                                    std::sin(phi) * std::cos(theta)));
  EXPECT_LT(length(choice.camera.position - eye), 1e-5f);
  EXPECT_NEAR(choice.camera.vertical_fov, std::numbers::pi / 4.0, 1e-6);
  EXPECT_NEAR(choice.camera.depth(Vec3(1.0f, 2.0f, 3.0f)), 4.0f, 1e-5f);
  EXPECT_NE(choice.description.find("(1001, 2, -497)"), std::string::npos) << choice.description;
}

TEST(CameraChoice, OrbitWithoutTarget_LooksAtTheCentre) {
  const shading::Scene scene = make_scene();
  RenderOptions options;
  options.orbit = DVec3(0.0, 90.0, 10.0);
  const Camera camera = choose_camera(scene, options, nullptr, 1.0f).camera;
  EXPECT_LT(length(camera.position - Vec3(1.0f, 1.0f, 11.0f)), 1e-4f);
  EXPECT_LT(length(camera.backward - Vec3(0.0f, 0.0f, 1.0f)), 1e-5f);
}

TEST(CameraChoice, EmptySceneWithoutCamera_IsFinite) {
  const shading::Scene scene;
  RenderOptions options;
  EXPECT_TRUE(geometry::is_finite(choose_camera(scene, options, nullptr, 1.0f).camera.position));
  options.orbit = DVec3(0.0, 90.0, 1.0);
  EXPECT_TRUE(geometry::is_finite(choose_camera(scene, options, nullptr, 1.0f).camera.position));
}

TEST(CameraChoice, FieldOfView_IsForPerspectiveOnly) {
  const shading::Scene scene = make_scene();
  RenderOptions options;
  options.fov = 90.0f;
  EXPECT_NEAR(choose_camera(scene, options, scene.cameras.data(), 1.0f).camera.vertical_fov,
              std::numbers::pi / 2.0, 1e-6);
  EXPECT_THROW((void)choose_camera(scene, options, &scene.cameras[1], 1.0f), UsageError);
}

TEST(PictureSize, WhatIsNotGiven_FollowsFromTheShape) {
  RenderOptions options;
  const auto size = [&](float aspect) {
    const ImageSize chosen = choose_size(options, aspect);
    return std::to_string(chosen.width) + "x" + std::to_string(chosen.height);
  };
  EXPECT_EQ(size(0.0f), "1280x720");
  EXPECT_EQ(size(2.0f), "1280x640");
  options.height = 100;
  EXPECT_EQ(size(0.0f), "178x100");
  EXPECT_EQ(size(0.5f), "50x100");
  EXPECT_EQ(size(1e30f), "65535x100");
  EXPECT_EQ(size(1e-30f), "1x100");
  options.width = 30;
  EXPECT_EQ(size(2.0f), "30x100");
  options.height.reset();
  EXPECT_EQ(size(1.5f), "30x20");
}

TEST(PictureRegion, CropOutsideOrTooLarge_IsRefused) {
  RenderOptions options;
  EXPECT_EQ(choose_region(options.crop, {20, 10}), (shading::PixelRegion{0, 0, 20, 10}));
  EXPECT_THROW((void)choose_region(options.crop, {65535, 65535}), UsageError);
  options.crop = shading::PixelRegion{18, 9, 2, 1};
  EXPECT_EQ(choose_region(options.crop, {20, 10}), *options.crop);
  EXPECT_EQ(choose_region(options.crop, {65535, 65535}), *options.crop);
  options.crop = shading::PixelRegion{19, 9, 2, 1};
  EXPECT_THROW((void)choose_region(options.crop, {20, 10}), UsageError);
}

TEST(WorldToCamera, RandomPoints_LandWhereTheCameraSeesThem) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(-10.0f, 10.0f);
  const auto point = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  const DVec3 origin(100.0, 200.0, -300.0);
  for (int i = 0; i < 1000; ++i) {
    const Camera camera = geometry::look_at(point(), point(), 1.0f);
    const std::vector<float> m = world_to_camera(camera, origin);
    const Vec3 p = point();
    const DVec3 world = DVec3(p) + origin;
    const auto coordinate = [&](std::size_t k) {
      return world.x * m[k] + world.y * m[4 + k] + world.z * m[8 + k] + m[12 + k];
    };
    EXPECT_NEAR(coordinate(0), dot(p - camera.position, camera.right), 1e-3);
    EXPECT_NEAR(coordinate(1), dot(p - camera.position, camera.up), 1e-3);
    EXPECT_NEAR(coordinate(2), -camera.depth(p), 1e-3);
    EXPECT_EQ(m[15], 1.0f);
  }
}

}  // namespace
}  // namespace lume::cli
