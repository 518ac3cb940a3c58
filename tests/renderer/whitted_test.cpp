// SPDX-License-Identifier: Apache-2.0
// The recursion against light that can be calculated by hand.
#include "shading/fresnel.h"
#include "tests/renderer/radiance.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::renderer {
namespace {

using geometry::k_pi;
using geometry::Ray;
using geometry::Vec3;
using shading::Material;
using shading::PunctualLight;
using shading::Scene;
using test::add_surface;
using test::make_matte;

Scene matte_square(const Color& albedo, float half_size = 2.0f) {
  Scene scene;
  make_matte(add_surface(scene, test::square_mesh(half_size)), albedo);
  return scene;
}

PunctualLight point_light(const Vec3& position, const Color& intensity) {
  PunctualLight light;
  light.position = position;
  light.intensity = intensity;
  return light;
}

TEST(Whitted, MatteSquareUnderAPointLight_IsLambertsLaw) {
  Scene scene = matte_square({0.8f, 0.4f, 0.2f});
  const Vec3 light(1.1f, 0.05f, 2.0f);
  scene.lights.push_back(point_light(light, Color(30.0f)));
  const Vec3 offset = light - Vec3(0.1f, 0.05f, 0.0f);
  const float d2 = dot(offset, offset);
  const float cosine = offset.z / std::sqrt(d2);
  const Radiance r = mean_radiance(scene, k_down_z);
  expect_near(r.color(), Color(0.8f, 0.4f, 0.2f) * (30.0f * cosine / d2 / k_pi), 1e-4f);
  EXPECT_EQ(r.alpha, 1.0f);
}

TEST(Whitted, DirectionalLight_GivesAlbedoTimesIlluminanceOverPi) {
  Scene scene = matte_square(Color(0.5f));
  PunctualLight sun;
  sun.kind = PunctualLight::Kind::directional;
  sun.direction = glm::normalize(Vec3(1, 0, -1));
  sun.intensity = Color(10.0f);
  scene.lights.push_back(sun);
  expect_near(mean_radiance(scene, k_down_z).color(), Color(0.5f * 10.0f * std::sqrt(0.5f) / k_pi),
              1e-5f);
}

TEST(Whitted, Occluder_CastsAHardShadow) {
  Scene scene = matte_square(Color(0.5f));
  scene.lights.push_back(point_light({0.1f, 0.05f, 4.0f}, Color(1.0f)));
  EXPECT_GT(mean_radiance(scene, k_down_z).color().x, 0.0f);
  make_matte(add_surface(scene, test::square_mesh(0.3f), test::translation(0, 0, 3)), Color(1.0f));
  const Ray below{.origin = {0.1f, 0.05f, 2.0f}, .direction = {0, 0, -1}};
  EXPECT_EQ(mean_radiance(scene, below).color(), Color(0.0f));
}

TEST(Whitted, WhiteFurnace_MatteSphereHasItsAlbedo) {
  Scene scene;
  make_matte(add_surface(scene, test::sphere_mesh(48)), {0.7f, 0.5f, 0.3f});
  scene.environment.emplace(Color(2.0f));
  test::Random random(1);
  for (int i = 0; i < 5; ++i) {
    const Vec3 outward = random.direction();
    const Ray ray{.origin = 4.0f * outward, .direction = -outward};
    expect_near(mean_radiance(scene, ray, 4096).color(), Color(1.4f, 1.0f, 0.6f), 0.02f);
  }
}

TEST(Whitted, MirrorInAnEnvironment_ShowsItInTheMirrorDirection) {
  Scene scene;
  Material& metal = add_surface(scene, test::square_mesh(2.0f));
  metal.base_color = {1.0f, 0.8f, 0.5f};
  metal.roughness = 0.0f;
  // Red light from +x, none from elsewhere (u = 0.5 is +x).
  std::vector<Color> pixels;
  pixels.reserve(2048);
  for (int i = 0; i < 64 * 32; ++i) {
    const int x = i % 64;
    pixels.emplace_back(x >= 20 && x < 44 ? 1.0f : 0.0f, 0.0f, 0.0f);
  }
  scene.environment.emplace(64, 32, pixels);
  const Vec3 in = glm::normalize(Vec3(1, 0, -1));
  const Ray towards_x{.origin = -3.0f * in, .direction = in};
  const float cosine = std::sqrt(0.5f);
  const Color f = shading::fresnel_schlick(Color(1.0f, 0.8f, 0.5f), Color(1.0f), cosine);
  expect_near(mean_radiance(scene, towards_x).color(), Color(f.x, 0, 0), 1e-4f);
  const Ray towards_minus_x{.origin = 3.0f * in * Vec3(1, 0, -1), .direction = in * Vec3(-1, 0, 1)};
  EXPECT_EQ(mean_radiance(scene, towards_minus_x).color(), Color(0.0f));
}

TEST(Whitted, RoughMetal_BothStrategiesTogetherCountLightOnce) {
  // The environment's light on a rough metal comes by shadow rays and by reflection rays. A
  // hole-free enclosure of constant light must give the same as the reflection alone: its albedo.
  for (const float roughness : {0.2f, 0.5f, 1.0f}) {
    Scene scene;
    Material& metal = add_surface(scene, test::square_mesh(2.0f));
    metal.roughness = roughness;
    scene.environment.emplace(Color(1.0f));
    const float both = mean_radiance(scene, k_down_z, 8192).color().x;
    // Depth 0 has no reflection ray, so the shadow rays take the whole light.
    const float shadow_rays_only = mean_radiance(scene, k_down_z, 65536, 0).color().x;
    EXPECT_NEAR(both, shadow_rays_only, roughness < 0.3f ? 0.1f : 0.02f) << roughness;
    EXPECT_LT(both, 1.001f);
  }
}

TEST(Whitted, EmissiveSquare_LightsLikeItsFormFactor) {
  // A square of half size h at height d over a point that faces it: the form factor between a
  // differential element and a parallel rectangle (Siegel and Howell, configuration 4), four
  // quarters.
  constexpr float k_h = 0.5f;
  constexpr float k_d = 1.0f;
  Scene scene = matte_square(Color(0.6f));
  geometry::DMat4 facing_down = test::translation(0, 0, k_d);
  facing_down[1][1] = -1.0;
  facing_down[2][2] = -1.0;  // half a turn about x
  Material& lamp = add_surface(scene, test::square_mesh(k_h), facing_down);
  make_matte(lamp, Color(0.0f));
  lamp.emission = Color(5.0f);
  const float x = k_h / k_d;
  const float root = std::sqrt(1.0f + x * x);
  const float quarter = (x / root * std::atan(x / root)) / k_pi;  // a = b
  const Ray ray{.origin = {0, 0, 0.5f}, .direction = {0, 0, -1}};
  EXPECT_NEAR(mean_radiance(scene, ray, 16384).color().x, 0.6f * 5.0f * 4.0f * quarter, 3e-3f);
  // Seen directly it shows its radiance, and its back shows none.
  const Ray up{.origin = {0, 0, 0.5f}, .direction = {0, 0, 1}};
  EXPECT_EQ(mean_radiance(scene, up).color(), Color(5.0f));
  EXPECT_EQ(mean_radiance(scene, {.origin = {0, 0, 3}, .direction = {0, 0, -1}}, 256).color().x,
            mean_radiance(scene, ray, 256).color().x)
      << "back faces of single-sided surfaces are not seen";
}

/// A lamp above the scene, found by shadow and reflection rays or by shadow rays alone, gives the
/// same light.
void expect_lamp_counted_once(Scene& scene) {
  Material& lamp = add_surface(scene, test::square_mesh(1.0f), test::translation(0, 0, 6));
  lamp.double_sided = true;
  lamp.base_color = Color(0.0f);
  lamp.emission = Color(3.0f);
  const float both = mean_radiance(scene, k_down_z, 16384).color().x;
  const float shadow_rays_only = mean_radiance(scene, k_down_z, 65536, 0).color().x;
  EXPECT_NEAR(both, shadow_rays_only, 0.01f * shadow_rays_only);
}

TEST(Whitted, RoughReflectionOfAnEmitter_CountsItOnce) {
  Scene scene;
  Material& metal = add_surface(scene, test::square_mesh(2.0f));
  metal.roughness = 0.5f;
  expect_lamp_counted_once(scene);
}

TEST(Whitted, RoughReflectionThroughABlendedPane_CountsItOnce) {
  // The pane is close to the lamp: were the distance counted from it, and not from the metal, the
  // shares of the two strategies would not add up to 1.
  Scene scene;
  add_surface(scene, test::square_mesh(2.0f)).roughness = 0.5f;
  Material& pane = add_surface(scene, test::square_mesh(9.0f), test::translation(0, 0, 5.5));
  pane.unlit = true;
  pane.double_sided = true;
  pane.base_color = Color(0.0f);
  pane.alpha_mode = shading::AlphaMode::blend;
  pane.alpha = 0.5f;
  expect_lamp_counted_once(scene);
}

TEST(Whitted, MirrorWithATiltedNormal_DoesNotLookBelowItsSurface) {
  // Interpolated normals 60 degrees off the plane's send the reflection into the plane, under which
  // there is a light that must not be seen.
  Scene scene;
  geometry::Mesh plane = test::square_mesh(2.0f);
  plane.normals.assign(4, Vec3(std::sqrt(0.75f), 0.0f, 0.5f));
  add_surface(scene, plane).roughness = 0.0f;
  Material& lamp = add_surface(scene, test::square_mesh(50.0f), test::translation(0, 0, -3));
  lamp.double_sided = true;
  lamp.emission = Color(1.0f);
  EXPECT_EQ(mean_radiance(scene, k_down_z).color(), Color(0.0f));
}

TEST(Whitted, SingleSidedBackFace_IsNotSeenAndDoubleSidedIsLitFromItsSide) {
  Scene scene = matte_square(Color(0.5f));
  scene.lights.push_back(point_light({0.1f, 0.05f, -4.0f}, Color(16.0f)));
  const Ray from_behind{.origin = {0.1f, 0.05f, -2.0f}, .direction = {0, 0, 1}};
  EXPECT_EQ(mean_radiance(scene, from_behind).alpha, 0.0f);
  scene.materials[0].double_sided = true;
  expect_near(mean_radiance(scene, from_behind).color(), Color(0.5f / k_pi), 1e-5f);
}

TEST(Whitted, MaxDepth_CutsTheRecursion) {
  // Two facing mirrors: each further depth shows one more reflection of the emissive rim.
  Scene scene;
  add_surface(scene, test::square_mesh(2.0f)).roughness = 0.0f;
  geometry::DMat4 facing_down = test::translation(0, 0, 10);
  facing_down[1][1] = -1.0;
  facing_down[2][2] = -1.0;
  Material& top = add_surface(scene, test::square_mesh(2.0f), facing_down);
  top.roughness = 0.0f;
  top.emission = Color(1.0f);
  for (int depth = 0; depth <= 6; ++depth) {
    // Perfect mirrors: down, up (1), down, up (1) ...
    const int lamps_met = (depth + 1) / 2;
    EXPECT_NEAR(mean_radiance(scene, k_down_z, 1, depth).color().x, static_cast<float>(lamps_met),
                1e-4f);
  }
}

TEST(Whitted, Unlit_ShowsItsBaseColourWhateverTheLight) {
  Scene scene;
  Material& sign = add_surface(scene, test::square_mesh(2.0f));
  sign.unlit = true;
  sign.base_color = {0.1f, 0.2f, 0.3f};
  scene.lights.push_back(point_light({0, 0, 3}, Color(100.0f)));
  scene.environment.emplace(Color(3.0f));
  EXPECT_EQ(mean_radiance(scene, k_down_z).color(), Color(0.1f, 0.2f, 0.3f));
}

TEST(Whitted, SmoothSphereInAnyLight_HasNoNonFiniteSample) {
  test::Random random(3);
  for (int i = 0; i < 40; ++i) {
    Scene scene;
    Material& material = add_surface(scene, test::sphere_mesh(8), test::random_transform(random));
    const auto pick = [&] { return std::round(random.uniform(0.0f, 4.0f)) / 4.0f; };
    material.base_color = {pick(), pick(), pick()};
    material.metallic = pick();
    material.roughness = pick();
    material.transmission = pick();
    material.thickness = pick();
    material.ior = 1.0f + pick();
    material.double_sided = pick() > 0.5f;
    material.emission = Color(pick() > 0.7f ? 1.0f : 0.0f);
    scene.environment.emplace(Color(1.0f));
    scene.lights.push_back(point_light(random.cube(3.0f), Color(5.0f)));
    const auto bounds = scene.world.bounds();
    for (int k = 0; k < 100; ++k) {
      const Vec3 target = bounds.center() + random.cube(0.3f) * bounds.size();
      const Vec3 direction = random.direction();
      const Radiance r = mean_radiance(
          scene, {.origin = target - 3.0f * bounds.radius() * direction, .direction = direction});
      ASSERT_TRUE(geometry::is_finite(r.color())) << i << " " << k;
      ASSERT_GE(std::min({r.color().x, r.color().y, r.color().z}), 0.0f);
      ASSERT_LE(r.alpha, 1.0f);
    }
  }
}

}  // namespace
}  // namespace lume::renderer
