// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/lighting.h"

#include <gtest/gtest.h>

namespace lume::cli {
namespace {

/// One triangle of one material.
shading::Scene make_scene(const shading::Material& material) {
  shading::Scene scene;
  geometry::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  scene.world.objects.resize(1);
  scene.world.objects[0].geometries.push_back({mesh});
  scene.world.instances.resize(1);
  scene.materials = {material};
  return scene;
}

TEST(Lighting, DarkScene_GetsTheHiddenStudio) {
  shading::Scene scene = make_scene({});
  EXPECT_FALSE(has_light(scene));
  light_scene({}, scene);
  ASSERT_TRUE(scene.environment);
  EXPECT_FALSE(scene.environment->visible);
}

TEST(Lighting, LampOrLight_NeedsNoStudio) {
  shading::Material lamp;
  lamp.emission = shading::Color(0.5f);
  shading::Scene scene = make_scene(lamp);
  light_scene({}, scene);
  EXPECT_FALSE(scene.environment);

  scene = make_scene({});
  scene.lights.resize(1);
  light_scene({}, scene);
  EXPECT_FALSE(scene.environment);
}

TEST(Lighting, ShapesThatLightOthers_NeedNoStudio) {
  shading::Material lamp;
  lamp.emission = shading::Color(0.5f);
  shading::Scene scene = make_scene(lamp);
  scene.world.objects[0].geometries[0].surface = geometry::Shape(geometry::Sphere{1.0});
  EXPECT_TRUE(has_light(scene));
  scene.world.objects[0].geometries[0].surface = geometry::Shape(geometry::Torus{});
  EXPECT_FALSE(has_light(scene)) << "it is only seen";
}

TEST(Lighting, AmbientLight_ComesFromTheFileOrTheOptions) {
  shading::Scene scene = make_scene({});
  ViewOptions options;
  options.ambient = geometry::DVec3(0.25, 0.5, 1.0);
  light_scene(options, scene);
  EXPECT_EQ(scene.ambient, shading::Color(0.25f, 0.5f, 1.0f));
  EXPECT_FALSE(scene.environment) << "it is light enough";
  light_scene({}, scene);
  EXPECT_EQ(scene.ambient, shading::Color(0.25f, 0.5f, 1.0f)) << "the file's";
}

TEST(Lighting, GlowingTexture_CountsFromMoreThanOneNit) {
  shading::Material material;
  material.emission_texture.texture = 0;
  material.emission = shading::Color(1.0f);
  EXPECT_FALSE(has_light(make_scene(material)));
  material.emission = shading::Color(2.0f);
  EXPECT_TRUE(has_light(make_scene(material)));
}

TEST(Lighting, LampThatIsNotPlaced_DoesNotCount) {
  shading::Material lamp;
  lamp.emission = shading::Color(5.0f);
  shading::Scene scene = make_scene(lamp);
  scene.world.instances.clear();
  EXPECT_FALSE(has_light(scene));
}

TEST(Lighting, Background_IsSeenAndLights) {
  shading::Scene scene = make_scene({});
  ViewOptions options;
  options.background = geometry::DVec3(0.25, 0.5, 1.0);
  light_scene(options, scene);
  ASSERT_TRUE(scene.environment && scene.environment->visible);
  EXPECT_EQ(scene.environment->radiance({0.0f, 1.0f, 0.0f}), shading::Color(0.25f, 0.5f, 1.0f));
}

}  // namespace
}  // namespace lume::cli
