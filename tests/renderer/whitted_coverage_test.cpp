// SPDX-License-Identifier: Apache-2.0
// What lies behind: alpha-blended layers, the backdrop, thin and solid glass.
#include "shading/fresnel.h"
#include "tests/renderer/radiance.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::renderer {
namespace {

using geometry::Ray;
using geometry::Vec3;
using shading::Material;
using shading::Scene;
using test::add_surface;

TEST(Whitted, BlendedLayers_CoverByTheirAlpha) {
  Scene scene;
  for (int i = 0; i < 2; ++i) {
    Material& pane = add_surface(scene, test::square_mesh(2.0f), test::translation(0, 0, i));
    pane.unlit = true;
    pane.alpha_mode = shading::AlphaMode::blend;
    pane.alpha = 0.25f;
    pane.base_color = i == 0 ? Color(1, 0, 0) : Color(0, 1, 0);
  }
  const Radiance r = mean_radiance(scene, k_down_z);
  expect_near(r.color(), {0.75f * 0.25f, 0.25f, 0.0f}, 1e-6f);
  EXPECT_NEAR(r.alpha, 0.25f + 0.75f * 0.25f, 1e-6f);
}

TEST(Whitted, Backdrop_CountsAsCoverageOnlyWhenVisible) {
  Scene scene;
  EXPECT_EQ(mean_radiance(scene, k_down_z).alpha, 0.0f);
  scene.environment.emplace(Color(0.5f));
  EXPECT_EQ(mean_radiance(scene, k_down_z).alpha, 1.0f);
  EXPECT_EQ(mean_radiance(scene, k_down_z).color(), Color(0.5f));
  scene.environment->visible = false;
  EXPECT_EQ(mean_radiance(scene, k_down_z).alpha, 0.0f);
  EXPECT_EQ(mean_radiance(scene, k_down_z).color(), Color(0.0f));
}

TEST(Whitted, ThinPane_PassesWhatItDoesNotReflectTwice) {
  Scene scene;
  Material& backdrop = add_surface(scene, test::square_mesh(5.0f), test::translation(0, 0, -1));
  backdrop.unlit = true;
  Material& pane = add_surface(scene, test::square_mesh(2.0f));
  pane.metallic = 0.0f;
  pane.roughness = 0.0f;
  pane.transmission = 1.0f;
  pane.base_color = {1.0f, 0.5f, 0.25f};
  RayCounts counts;
  expect_near(mean_radiance(scene, k_down_z, 1, 5, &counts).color(),
              Color(1.0f, 0.5f, 0.25f) * 0.96f, 1e-5f);
  EXPECT_EQ(counts.camera, 1u);
  EXPECT_EQ(counts.refraction, 1u);
  EXPECT_EQ(counts.reflection, 1u);
}

TEST(Whitted, SolidSlab_ShiftsTheRayAndAbsorbsByBeerAndLambert) {
  // A slab of glass, 2 thick, seen at 45 degrees. Behind it an emissive plane tells x by its
  // texture coordinate... which vertex colours do here: red grows from 0 at x = -4 to 1 at x = 4.
  Scene scene;
  geometry::Mesh scale = test::square_mesh(4.0f);
  scale.colors = {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 0, 0, 1}, {0, 0, 0, 1}};
  add_surface(scene, scale, test::translation(0, 0, -1.5)).unlit = true;
  geometry::Mesh slab = test::square_mesh(50.0f);
  geometry::Mesh bottom = slab;
  for (Vec3& p : bottom.positions) p = {p.x, -p.y, -2.0f};  // faces down
  for (const Vec3& p : bottom.positions) slab.positions.push_back(p);
  slab.triangles.emplace_back(4, 5, 6);
  slab.triangles.emplace_back(4, 6, 7);
  slab.texcoords.clear();
  Material& glass = add_surface(scene, slab, test::translation(0, 0, 1));
  glass.metallic = 0.0f;
  glass.roughness = 0.0f;
  glass.transmission = 1.0f;
  glass.thickness = 1.0f;
  glass.attenuation_distance = 1.0f;
  glass.attenuation_color = {0.5f, 1.0f, 1.0f};
  const Vec3 in = glm::normalize(Vec3(1, 0, -1));
  const Ray ray{.origin = Vec3(-1, 0, 1) - in, .direction = in};
  // Snell: sin 45 / 1.5; then 0.5 more to the plane at 45 degrees again.
  const double sine = std::sqrt(0.5) / 1.5;
  const double cosine = std::sqrt(1.0 - sine * sine);
  const double x = -1.0 + 2.0 * sine / cosine + 0.5;
  const double absorbed = std::pow(0.5, 2.0 / cosine);
  const double enters =
      1.0 - static_cast<double>(shading::fresnel_schlick(0.04f, 1.0f, std::sqrt(0.5f)));
  const double leaves =
      1.0 - static_cast<double>(shading::fresnel_dielectric(static_cast<float>(cosine), 1.5f));
  // The internal reflections that come back down are worth under a percent and land elsewhere.
  const float red = mean_radiance(scene, ray, 1, 2).color().x;
  EXPECT_NEAR(red, (x + 4.0) / 8.0 * absorbed * enters * leaves, 2e-4);
}

}  // namespace
}  // namespace lume::renderer
