// SPDX-License-Identifier: Apache-2.0
// Each term of the course's formula, in scenes where it can be worked out by hand.
#include "renderer/pixel.h"
#include "renderer/render.h"
#include "tests/renderer/radiance.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::renderer {
namespace {

using geometry::k_pi;
using geometry::Ray;
using geometry::Vec3;
using shading::Phong;
using shading::PunctualLight;
using shading::Scene;
using test::add_surface;
using test::translation;

/// A light of the course's: L_p at any distance.
PunctualLight course_light(const Vec3& position, float strength) {
  PunctualLight light;
  light.position = position;
  light.intensity = Color(strength * k_pi);
  light.attenuation = Vec3(1.0f, 0.0f, 0.0f);
  return light;
}

Phong& add_phong_square(Scene& scene, const Color& color, double height = 0.0,
                        float half_size = 2.0f) {
  auto& material = add_surface(scene, test::square_mesh(half_size), translation(0, 0, height));
  material.base_color = color;
  material.double_sided = true;
  return material.phong.emplace();
}

Radiance radiance_of(const Scene& scene, const Ray& ray, const IntegratorSettings& settings = {},
                     const char* name = "whitted") {
  const PreparedScene prepared(scene, "embree");
  Ledger ledger;
  return make_integrator(name, prepared, settings)->radiance(ray, Sampler(1, 0, 0, 0), ledger);
}

const Ray k_down{.origin = {0, 0, 5}, .direction = {0, 0, -1}};

/// Down in the plane y = 0 at 45 degrees, to the origin.
Ray slanted() {
  const float s = std::sqrt(0.5f);
  return {.origin = {-3, 0, 3}, .direction = {s, 0, -s}};
}

TEST(LightTerms, Ambient_IsLaKaOa) {
  Scene scene;
  add_phong_square(scene, Color(0.8f, 0.4f, 0.2f)).ambient = 0.25f;
  scene.ambient = Color(2.0f, 1.0f, 0.5f);
  const LightTerms terms = radiance_of(scene, k_down).terms;
  expect_near(terms.ambient, {0.4f, 0.1f, 0.025f}, 1e-6f);
  EXPECT_EQ(terms.sum(), terms.ambient);
}

TEST(LightTerms, Diffuse_IsFattLpKdOdNl) {
  Scene scene;
  add_phong_square(scene, Color(0.8f, 0.4f, 0.2f)).diffuse = 0.5f;
  PunctualLight light = course_light({3, 0, 4}, 10.0f);  // 5 metres away, (n.l) = 0.8
  light.attenuation = Vec3(1.0f, 0.3f, 0.06f);           // 1 + 1.5 + 1.5 = 4
  scene.lights.push_back(light);
  const LightTerms terms = radiance_of(scene, k_down).terms;
  expect_near(terms.diffuse, Color(0.8f, 0.4f, 0.2f) * (0.5f * 0.8f * 10.0f / 4.0f), 1e-5f);
  EXPECT_EQ(terms.specular, Color(0.0f));
}

TEST(LightTerms, Specular_IsFattLpKsOsRvToTheN) {
  Scene scene;
  Phong& phong = add_phong_square(scene, Color(0.8f));
  phong.specular = 0.5f;
  phong.specular_color = Color(1.0f, 0.5f, 0.25f);
  phong.shininess = 4.0f;
  scene.lights.push_back(course_light({0, 0, 4}, 3.0f));
  // Light along the normal, viewer 45 degrees from it: (r.v)^4 = 1/4.
  const LightTerms terms = radiance_of(scene, slanted()).terms;
  expect_near(terms.specular, Color(1.0f, 0.5f, 0.25f) * (0.5f * 3.0f / 4.0f), 1e-5f);
}

TEST(LightTerms, Lights_AddUp) {
  Scene scene;
  add_phong_square(scene, Color(1.0f));
  scene.lights.push_back(course_light({0, 0, 4}, 0.25f));
  scene.lights.push_back(course_light({0, 0, 9}, 0.5f));
  expect_near(radiance_of(scene, k_down).terms.diffuse, Color(0.75f), 1e-6f);
}

TEST(LightTerms, Reflected_IsKrOsTimesWhatTheMirrorSees) {
  Scene scene;
  Phong& mirror = add_phong_square(scene, Color(0.0f));
  mirror.reflection = 0.5f;
  mirror.specular_color = Color(1.0f, 0.5f, 0.25f);
  // A glowing wall that the mirrored ray, up and to +x, meets head on.
  auto& wall = add_surface(scene, test::square_mesh(1.0f),
                           translation(3, 0, 3) * glm::dmat4(glm::mat4_cast(glm::angleAxis(
                                                      -3.0 * M_PI / 4.0, glm::dvec3(0, 1, 0)))));
  test::make_matte(wall, Color(0.0f));
  wall.double_sided = true;
  wall.emission = Color(4.0f);
  const Radiance light = radiance_of(scene, slanted());
  expect_near(light.terms.reflected, {2.0f, 1.0f, 0.5f}, 1e-6f);
  EXPECT_EQ(light.depth, 1);
  const Radiance cast = radiance_of(scene, slanted(), {}, "raycast");
  EXPECT_EQ(cast.terms.reflected, Color(0.0f)) << "ray casting has no recursion";
  EXPECT_EQ(cast.depth, 0);
}

TEST(LightTerms, Transmitted_IsKtOtTimesWhatTheRefractedRaySees) {
  // Through a slab of index 1.5 from z = 0.5 to -0.5, at 45 degrees: the ray meets the upper face
  // at x = -0.5, the lower one tan(28.1 degrees) further on, and comes out parallel.
  Scene scene;
  add_surface(scene, geometry::Box{{4.0, 4.0, 0.5}});
  auto& slab = scene.materials.back();
  slab.ior = 1.5f;
  Phong& glass = slab.phong.emplace();
  glass.diffuse = 0.0f;
  glass.transmission = 0.5f;
  glass.transmission_color = Color(1.0f, 0.5f, 0.25f);
  const double inner = std::asin(std::sqrt(0.5) / 1.5);
  const double x = -0.5 + std::tan(inner) + 4.0;  // at z = -4.5
  auto& screen = add_surface(scene, test::square_mesh(0.01f), translation(x, 0, -4.5));
  test::make_matte(screen, Color(0.0f));
  screen.double_sided = true;
  screen.emission = Color(8.0f);
  const Radiance light = radiance_of(scene, slanted());
  expect_near(light.terms.transmitted, Color(8.0f) * Color(0.25f, 0.0625f, 0.015625f), 1e-5f);
  EXPECT_EQ(light.depth, 2);
}

TEST(LightTerms, Absorption_IsBeersAndLamberts) {
  Scene scene;
  add_surface(scene, geometry::Box{{4.0, 4.0, 1.0}});
  auto& slab = scene.materials.back();
  slab.phong.emplace().transmission = 1.0f;
  slab.phong->diffuse = 0.0f;
  slab.attenuation_color = Color(0.5f, 0.25f, 1.0f);
  slab.attenuation_distance = 1.0f;
  scene.background = Color(1.0f);
  expect_near(radiance_of(scene, k_down).terms.transmitted, {0.25f, 0.0625f, 1.0f}, 1e-5f);
}

TEST(LightTerms, TotalReflection_LeavesNoTransmittedRay) {
  // From inside of a glass block at 45 degrees, beyond the critical angle of 41.8: k_t counts for
  // nothing, and the reflected ray meets the side at 45 degrees, too.
  Scene scene;
  add_surface(scene, geometry::Box{{4.0, 4.0, 4.0}});
  auto& block = scene.materials.back();
  block.ior = 1.5f;
  Phong& glass = block.phong.emplace();
  glass.transmission = 1.0f;
  glass.reflection = 0.5f;
  glass.diffuse = 0.0f;
  scene.background = Color(1.0f);
  const Ray inside{.origin = {-3, 0, 3}, .direction = slanted().direction};
  const Radiance light = radiance_of(scene, inside, {.max_depth = 1});
  EXPECT_EQ(light.terms.transmitted, Color(0.0f));
  block.ior = 1.4f;  // critical at 45.6 degrees
  expect_near(radiance_of(scene, inside, {.max_depth = 1}).terms.transmitted, Color(1.0f), 1e-6f);
}

TEST(LightTerms, Shadow_IsWhatAnOccluderTakes) {
  Scene scene;
  add_phong_square(scene, Color(0.5f));
  scene.lights.push_back(course_light({0, 0, 8}, 2.0f));
  const Ray beside{.origin = {-3, 0, 3}, .direction = slanted().direction};
  EXPECT_EQ(radiance_of(scene, beside).shadow, Color(0.0f));
  add_phong_square(scene, Color(0.5f), 6.0, 0.5f);
  for (const char* name : {"whitted", "raycast"}) {
    const Radiance dark = radiance_of(scene, beside, {}, name);
    EXPECT_EQ(dark.terms.diffuse, Color(0.0f));
    expect_near(dark.shadow, Color(1.0f), 1e-6f);
    const Radiance lit = radiance_of(scene, beside, {.shadows = false}, name);
    expect_near(lit.terms.diffuse, Color(1.0f), 1e-6f);
    EXPECT_EQ(lit.shadow, Color(0.0f));
  }
}

TEST(LightTerms, ShadowThroughGlass_KeepsKtASurface) {
  Scene scene;
  add_phong_square(scene, Color(1.0f));
  scene.lights.push_back(course_light({0, 0, 8}, 1.0f));
  add_surface(scene, geometry::Sphere{0.5}, translation(0, 0, 6));
  Phong& glass = scene.materials.back().phong.emplace();
  glass.transmission = 0.9f;
  glass.transmission_color = Color(1.0f, 0.5f, 0.1f);
  const Radiance light = radiance_of(scene, slanted());
  expect_near(light.terms.diffuse, {0.81f, 0.2025f, 0.0081f}, 1e-5f);
  expect_near(light.shadow, Color(1.0f) - Color(0.81f, 0.2025f, 0.0081f), 1e-5f);
}

TEST(LightTerms, Depth_EndsTheRecursion) {
  // Between two mirrors of k_r = 1/2 that glow with 1 each: 1 + 1/2 + 1/4 + ...
  Scene scene;
  for (const double height : {0.0, 10.0}) {
    add_phong_square(scene, Color(0.0f), height, 20.0f).reflection = 0.5f;
    scene.materials.back().emission = Color(1.0f);
  }
  double expected = 0.0;
  for (int depth = 0; depth <= 10; ++depth) {
    expected += std::pow(0.5, depth);
    const Radiance light = radiance_of(scene, k_down, {.max_depth = depth});
    EXPECT_NEAR(light.color().x, expected, 1e-6) << depth;
    EXPECT_EQ(light.depth, depth);
  }
}

TEST(LightTerms, Cutoff_LeavesOutWhatCountsForLess) {
  Scene scene;
  for (const double height : {0.0, 10.0}) {
    add_phong_square(scene, Color(0.0f), height, 20.0f).reflection = 0.5f;
  }
  EXPECT_EQ(radiance_of(scene, k_down, {.max_depth = 50, .cutoff = 0.1f}).depth, 3);  // 1/8 > 0.1
  EXPECT_EQ(radiance_of(scene, k_down, {.max_depth = 50, .cutoff = 0.0f}).depth, 50);
}

TEST(LightTerms, Background_IsSeenButLightsNothing) {
  Scene scene;
  add_phong_square(scene, Color(1.0f));
  scene.background = Color(0.3f, 0.45f, 0.75f);
  EXPECT_EQ(radiance_of(scene, k_down).color(), Color(0.0f));
  const Ray up{.origin = {0, 0, 5}, .direction = {0, 0, 1}};
  EXPECT_EQ(radiance_of(scene, up).terms.emitted, Color(0.3f, 0.45f, 0.75f));
  EXPECT_EQ(radiance_of(scene, up).alpha, 1.0f);
}

TEST(LightTerms, AmbientOcclusion_IsThePartOfTheHemisphereThatIsFree) {
  // A disk of radius 1 at height 1 covers sin^2(45 degrees) = 1/2 of a hemisphere weighted by the
  // cosine; one that stands farther away than the distance covers nothing.
  Scene scene;
  add_phong_square(scene, Color(1.0f), 0.0, 50.0f);
  scene.ambient = Color(1.0f);
  add_surface(scene, geometry::Disk{1.0, 0.0},
              translation(0, 0, 1) *
                  glm::dmat4(glm::mat4_cast(glm::angleAxis(M_PI / 2.0, glm::dvec3(1, 0, 0)))));
  scene.materials.back().double_sided = true;
  const PreparedScene prepared(scene, "embree");
  const Ray below{.origin = {0.5f, 0, 0.5f}, .direction = glm::normalize(Vec3(-1, 0, -1))};
  for (const auto& [distance, expected] : {std::pair(100.0f, 0.5), std::pair(0.5f, 1.0)}) {
    const auto integrator = make_integrator("raycast", prepared, {.occlusion_distance = distance});
    double sum = 0.0;
    constexpr std::uint32_t k_samples = 16384;
    for (std::uint32_t s = 0; s < k_samples; ++s) {
      Ledger ledger;
      const Radiance light = integrator->radiance(below, Sampler(1, 0, 0, s), ledger);
      sum += static_cast<double>(light.terms.ambient.x);
    }
    EXPECT_NEAR(sum / k_samples, expected, 2e-3) << distance;
  }
}

}  // namespace
}  // namespace lume::renderer
