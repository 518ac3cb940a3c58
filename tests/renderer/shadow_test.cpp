// SPDX-License-Identifier: Apache-2.0
#include "renderer/shadow.h"

#include "shading/fresnel.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::renderer {
namespace {

using shading::Color;
using shading::Material;
using shading::Scene;
using test::add_surface;

const geometry::Ray k_up{.origin = {0.1f, 0.05f, -1.0f}, .direction = {0, 0, 1}, .t_max = 10.0f};

Transmittance trace(const Scene& scene, const geometry::Ray& ray = k_up) {
  const PreparedScene prepared(scene, "embree");
  RayCounts counts;
  const Transmittance result = trace_shadow(prepared, ray, counts);
  EXPECT_EQ(counts.shadow, 1u);
  return result;
}

void expect_near(const Color& a, const Color& b) { EXPECT_LT(length(a - b), 1e-5f); }

TEST(ShadowRay, OpenWay_PassesEverything) {
  expect_near(trace(Scene{}).color, Color(1.0f));
  Scene scene;
  add_surface(scene, test::square_mesh(), test::translation(0, 0, 20));
  expect_near(trace(scene).color, Color(1.0f));
}

TEST(ShadowRay, OneWaySurface_PassesLightFromBehindOnly) {
  const geometry::Ray down{.origin = {0.1f, 0.05f, 1.0f}, .direction = {0, 0, -1}};
  for (const bool other_see_through : {false, true}) {
    Scene scene;
    add_surface(scene, test::square_mesh());  // faces +z
    if (other_see_through) {
      add_surface(scene, test::square_mesh(), test::translation(0, 0, 30)).transmission = 1.0f;
    }
    // The ray up runs towards a light above, whose light falls on the front.
    EXPECT_EQ(trace(scene).color, Color(0.0f));
    expect_near(trace(scene, down).color, Color(1.0f));
    scene.materials[0].double_sided = true;
    EXPECT_EQ(trace(scene).color, Color(0.0f));
    EXPECT_EQ(trace(scene, down).color, Color(0.0f));
  }
}

TEST(ShadowRay, ClosedOneWayMesh_BlocksEverywhere) {
  Scene scene;
  add_surface(scene, test::sphere_mesh(16));
  for (const float x : {-0.7f, 0.0f, 0.5f}) {
    const geometry::Ray through{.origin = {x, 0.1f, -3.0f}, .direction = {0, 0, 1}};
    EXPECT_EQ(trace(scene, through).color, Color(0.0f));
  }
}

TEST(ShadowRay, BlendedSurfaces_PassOneMinusAlphaEach) {
  Scene scene;
  for (int i = 0; i < 3; ++i) {
    Material& pane = add_surface(scene, test::square_mesh(), test::translation(0, 0, i));
    pane.alpha_mode = shading::AlphaMode::blend;
    pane.alpha = 0.5f;
  }
  const Transmittance through = trace(scene);
  expect_near(through.color, Color(0.125f));
  EXPECT_FALSE(through.through_transmissive);
  // The ray's end counts: behind it there are no surfaces.
  geometry::Ray shorter = k_up;
  shorter.t_max = 1.5f;
  expect_near(trace(scene, shorter).color, Color(0.5f));
}

TEST(ShadowRay, MaskedSurface_IsAHoleOrAWall) {
  for (const float alpha : {0.3f, 0.7f}) {
    Scene scene;
    Material& material = add_surface(scene, test::square_mesh());
    scene.world.objects[0].geometries[0].has_holes = true;
    material.alpha_mode = shading::AlphaMode::mask;
    material.alpha = alpha;
    expect_near(trace(scene).color, Color(alpha < 0.5f ? 1.0f : 0.0f));
  }
}

TEST(ShadowRay, ColouredPane_TintsByItsBaseColourLessFresnel) {
  Scene scene;
  Material& pane = add_surface(scene, test::square_mesh());
  pane.metallic = 0.0f;
  pane.transmission = 0.5f;
  pane.base_color = {1.0f, 0.5f, 0.0f};
  const Transmittance through = trace(scene);
  expect_near(through.color, Color(1.0f, 0.5f, 0.0f) * 0.5f * 0.96f);
  EXPECT_TRUE(through.through_transmissive);
}

TEST(ShadowRay, SolidGlass_AbsorbsAlongTheWayInside) {
  Scene scene;
  Material& glass = add_surface(scene, test::sphere_mesh(64));
  glass.metallic = 0.0f;
  glass.transmission = 1.0f;
  glass.thickness = 1.0f;
  glass.attenuation_distance = 0.5f;
  glass.attenuation_color = {0.5f, 1.0f, 1.0f};
  const geometry::Ray through_center{.origin = {0, 0, -3}, .direction = {0, 0, 2}};
  const Color color = trace(scene, through_center).color;
  EXPECT_NEAR(color.x, 0.96f * 0.96f * std::pow(0.5f, 4.0f), 1e-3f);
  EXPECT_NEAR(color.y, 0.96f * 0.96f, 1e-3f);
  // From inside, half of the way.
  const geometry::Ray from_center{.origin = Vec3(0.0f), .direction = {0, 0, 2}};
  EXPECT_NEAR(trace(scene, from_center).color.x, 0.96f * std::pow(0.5f, 2.0f), 1e-3f);
}

TEST(Absorb, AttenuationDistance_LeavesTheAttenuationColour) {
  Material material;
  EXPECT_EQ(absorb(material, 100.0f), Color(1.0f));
  material.attenuation_distance = 2.0f;
  material.attenuation_color = {0.25f, 0.5f, 1.0f};
  expect_near(absorb(material, 2.0f), material.attenuation_color);
  expect_near(absorb(material, 1.0f), {0.5f, std::sqrt(0.5f), 1.0f});
  expect_near(absorb(material, 0.0f), Color(1.0f));
}

}  // namespace
}  // namespace lume::renderer
