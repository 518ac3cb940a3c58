// SPDX-License-Identifier: Apache-2.0
#include "shading/bsdf.h"

#include "shading/fresnel.h"
#include "tests/support/chi_squared.h"
#include "tests/support/near.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

namespace lume::shading {
namespace {

using test::expect_near;
using test::Random;

/// A material at a point with normal +z.
struct Surface {
  Material material;
  MaterialPoint point;

  Surface(const Color& base_color, float metallic, float roughness, float transmission = 0.0f,
          float thickness = 0.0f) {
    material.transmission = transmission;
    material.thickness = thickness;
    point.base_color = base_color;
    point.metallic = metallic;
    point.roughness = roughness;
    point.transmission = transmission;
    point.normal = {0, 0, 1};
  }
  [[nodiscard]] Bsdf seen_from(const Vec3& to_viewer, bool inside = false) {
    point.material = &material;
    return {point, to_viewer, inside};
  }
};

TEST(Bsdf, RoughDielectric_IsLambertUnderFresnel) {
  Surface surface(Color(0.8f, 0.4f, 0.2f), 0.0f, 1.0f);
  const Vec3 up(0, 0, 1);
  const Bsdf bsdf = surface.seen_from(up);
  // Light and viewer at the normal: F = F0 = 0.04 both ways, and on average 0.04 + 0.96 / 21.
  const float layer = 0.96f * 0.96f / (0.96f - 0.96f / 21.0f);
  expect_near(bsdf.eval_diffuse(up), Color(0.8f, 0.4f, 0.2f) * (layer / geometry::k_pi), 1e-6f);
  // F D G / 4 with alpha 1: D = 1 / pi and G = 1.
  expect_near(bsdf.eval_specular(up), Color(0.04f / (4.0f * geometry::k_pi)), 1e-6f);
}

/// KHR_materials_specular, section "Implementation", word for word.
Color specified_fresnel(const Surface& surface, float cosine) {
  const float n = surface.material.ior;
  const float r = (1.0f - n) / (1.0f + n);
  const Color f0 =
      glm::min(r * r * surface.point.specular_color, Color(1.0f)) * surface.point.specular;
  const Color f90(surface.point.specular);
  return f0 + (f90 - f0) * std::pow(1.0f - cosine, 5.0f);
}

TEST(Bsdf, Specular_ReflectsAsItsExtensionSays) {
  Random random(11);
  for (int i = 0; i < 2000; ++i) {
    Surface surface(Color(0.5f), 0.0f, 0.0f);
    surface.material.ior = random.uniform(1.4f, 2.0f);
    surface.point.specular = random.uniform();
    surface.point.specular_color =
        3.0f * Color(random.uniform(), random.uniform(), random.uniform());
    const Vec3 viewer = random.upper_direction();
    const Bsdf bsdf = surface.seen_from(viewer);
    const Color expected = specified_fresnel(surface, viewer.z);
    expect_near(bsdf.sample_reflection(random.square())->weight, expected, 1e-5f);
    // The base gets what the strongest colour leaves, on the way in and on the way out.
    const Vec3 light = random.upper_direction();
    const auto leaves = [&](float cosine) {
      return 1.0f - max_component(specified_fresnel(surface, cosine));
    };
    const Color f0 = specified_fresnel(surface, 1.0f);
    const float average = max_component(f0) + (surface.point.specular - max_component(f0)) / 21.0f;
    const float base = leaves(viewer.z) * leaves(light.z) / (1.0f - average);
    expect_near(bsdf.eval_diffuse(light), Color(0.5f * base * light.z / geometry::k_pi), 1e-5f);
  }
}

TEST(Bsdf, SpecularZero_IsLambertAlone) {
  Surface surface(Color(0.8f, 0.4f, 0.2f), 0.0f, 0.5f);
  surface.point.specular = 0.0f;
  const Bsdf bsdf = surface.seen_from(glm::normalize(Vec3(1, 0, 0.2f)));
  const Vec3 light = glm::normalize(Vec3(0.3f, 0.1f, 0.5f));
  expect_near(bsdf.eval_diffuse(light), surface.point.base_color * (light.z / geometry::k_pi),
              1e-6f);
  EXPECT_EQ(bsdf.eval_specular(light), Color(0.0f));
  EXPECT_EQ(bsdf.reflection_color(), Color(0.0f));
}

TEST(Bsdf, SpecularOfAMetal_HasNoEffect) {
  Surface plain(Color(0.9f, 0.6f, 0.3f), 1.0f, 0.4f);
  Surface tinted = plain;
  tinted.point.specular = 0.2f;
  tinted.point.specular_color = {0.0f, 1.0f, 5.0f};
  const Vec3 viewer = glm::normalize(Vec3(0.2f, 0.5f, 0.6f));
  const Vec3 light = glm::normalize(Vec3(-0.4f, 0.1f, 0.5f));
  EXPECT_EQ(plain.seen_from(viewer).eval_specular(light),
            tinted.seen_from(viewer).eval_specular(light));
}

TEST(Bsdf, SpecularInsideASolid_TintsButKeepsTotalReflection) {
  Surface surface(Color(1.0f), 0.0f, 0.0f, 1.0f, 1.0f);
  surface.point.specular = 0.5f;
  const Vec3 steep = glm::normalize(Vec3(0.2f, 0.0f, 1.0f));
  const float reflectance = fresnel_dielectric(steep.z, 1.5f);
  expect_near(surface.seen_from(steep, true).reflection_color(), Color(0.5f * reflectance), 1e-6f);
  const Vec3 flat = glm::normalize(Vec3(1.0f, 0.0f, 0.3f));  // beyond the critical angle
  EXPECT_EQ(surface.seen_from(flat, true).reflection_color(), Color(1.0f));
}

TEST(Bsdf, Metal_HasNoDiffuseAndReflectsItsColour) {
  Surface surface(Color(1.0f, 0.7f, 0.3f), 1.0f, 0.0f);
  const Vec3 up(0, 0, 1);
  const Bsdf bsdf = surface.seen_from(up);
  EXPECT_EQ(bsdf.eval_diffuse(up), Color(0.0f));
  const auto sample = bsdf.sample_reflection({0.3f, 0.6f});
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->pdf, 0.0f) << "a mirror";
  expect_near(sample->direction, up, 1e-6f);
  expect_near(sample->weight, Color(1.0f, 0.7f, 0.3f), 1e-6f);
}

TEST(Bsdf, Mirror_ReflectsAtTheNormal) {
  Random random(1);
  Surface surface(Color(1.0f), 1.0f, 0.0f);
  for (int i = 0; i < 500; ++i) {
    surface.point.normal = random.direction();
    Vec3 viewer = random.direction();
    if (dot(viewer, surface.point.normal) < 0.0f) viewer = -viewer;
    const auto sample = surface.seen_from(viewer).sample_reflection(random.square());
    ASSERT_TRUE(sample);
    ASSERT_LT(length(sample->direction - reflect(viewer, surface.point.normal)), 1e-5f);
  }
}

TEST(Bsdf, RandomMaterials_AreReciprocal) {
  Random random(2);
  for (int i = 0; i < 3000; ++i) {
    const Color color(random.uniform(), random.uniform(), random.uniform());
    Surface surface(color, random.uniform(), random.uniform(0.1f, 1.0f));
    surface.point.specular = random.uniform();
    surface.point.specular_color = 2.0f * Color(random.uniform(), random.uniform(), 1.0f);
    const Vec3 a = random.upper_direction();
    const Vec3 b = random.upper_direction();
    const Bsdf from_a = surface.seen_from(a);
    const Bsdf from_b = surface.seen_from(b);
    const Color ab = (from_a.eval_diffuse(b) + from_a.eval_specular(b)) / b.z;
    const Color ba = (from_b.eval_diffuse(a) + from_b.eval_specular(a)) / a.z;
    ASSERT_LT(length(ab - ba), 2e-3f * length(ab) + 1e-6f) << "case " << i;
  }
}

TEST(Bsdf, ReflectionSamples_CarryValueOverDensity) {
  Random random(3);
  int samples = 0;
  for (int i = 0; i < 5000; ++i) {
    Surface surface(Color(0.9f, 0.5f, 0.2f), random.uniform(), random.uniform(0.2f, 1.0f));
    const Bsdf bsdf = surface.seen_from(random.upper_direction());
    const auto sample = bsdf.sample_reflection(random.square());
    if (!sample) continue;
    ++samples;
    const float pdf = bsdf.reflection_pdf(sample->direction);
    ASSERT_NEAR(sample->pdf / pdf, 1.0f, 1e-2f) << "case " << i;
    const Color expected = bsdf.eval_specular(sample->direction) / pdf;
    ASSERT_LT(length(sample->weight - expected), 1e-2f * length(expected)) << "case " << i;
  }
  EXPECT_GT(samples, 4000);
}

TEST(Bsdf, ReflectedDirections_FollowTheirDensity) {
  constexpr int k_samples = 200000;
  Random random(4);
  for (const float roughness : {0.5f, 1.0f}) {
    Surface surface(Color(1.0f), 1.0f, roughness);
    const Bsdf bsdf = surface.seen_from(glm::normalize(Vec3(0.6f, 0.2f, 0.5f)));
    test::SphereCells cells(16, 24, 0.0);
    int drawn = 0;
    for (int i = 0; i < k_samples; ++i) {
      const auto sample = bsdf.sample_reflection(random.square());
      if (!sample) continue;
      cells.count(sample->direction);
      ++drawn;
    }
    const double integral = cells.expect(
        [&](double x, double y, double z) {
          const Vec3 w(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
          return static_cast<double>(bsdf.reflection_pdf(w));
        },
        k_samples, 16);
    // What the density lacks to 1 are the directions that go into the surface.
    EXPECT_NEAR(integral, static_cast<double>(drawn) / k_samples, 5e-3);
    cells.test();
  }
}

TEST(Bsdf, WhiteSurfaces_NeverReflectMoreThanArrives) {
  Random random(5);
  constexpr int k_samples = 100000;
  for (const float metallic : {0.0f, 0.5f, 1.0f}) {
    for (const float roughness : {0.0f, 0.3f, 1.0f}) {
      for (const float cosine : {0.1f, 0.5f, 1.0f}) {
        Surface surface(Color(1.0f), metallic, roughness);
        const Vec3 viewer(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
        const Bsdf bsdf = surface.seen_from(viewer);
        double albedo = 0.0;
        for (int i = 0; i < k_samples; ++i) {
          if (const auto sample = bsdf.sample_reflection(random.square())) {
            albedo += static_cast<double>(sample->weight.x);
          }
          Vec3 light = random.direction();  // diffuse, uniformly over the hemisphere
          light.z = std::abs(light.z);
          albedo += static_cast<double>(bsdf.eval_diffuse(light).x) * 2.0 * M_PI;
        }
        albedo /= k_samples;
        EXPECT_LT(albedo, 1.01) << metallic << " " << roughness << " " << cosine;
        if (roughness == 0.0f) {
          EXPECT_GT(albedo, 0.99);  // nothing is lost but between rough microfacets
        }
      }
    }
  }
}

TEST(Bsdf, SmoothSolid_RefractsBySnellAndLosesFresnel) {
  Surface glass(Color(1.0f), 0.0f, 0.0f, 1.0f, 1.0f);
  const Vec3 viewer = glm::normalize(Vec3(0.5f, 0.0f, 1.0f));
  const auto entering = glass.seen_from(viewer).sample_transmission({0.5f, 0.5f});
  ASSERT_TRUE(entering);
  expect_near(entering->direction, *refract(viewer, {0, 0, 1}, 1.0f / 1.5f), 1e-6f);
  expect_near(entering->weight, Color(1.0f - fresnel_schlick(0.04f, 1.0f, viewer.z)), 1e-5f);
  // From inside, beyond the critical angle of 41.8 degrees, all is reflected.
  const Vec3 flat = glm::normalize(Vec3(1.0f, 0.0f, 1.0f));
  const Bsdf inside = glass.seen_from(flat, true);
  EXPECT_FALSE(inside.sample_transmission({0.5f, 0.5f}));
  expect_near(inside.sample_reflection({0.5f, 0.5f})->weight, Color(1.0f), 1e-6f);
}

TEST(Bsdf, ThinSheet_LetsLightStraightThrough) {
  Surface sheet(Color(0.5f, 1.0f, 0.25f), 0.0f, 0.0f, 1.0f);
  const Vec3 viewer = glm::normalize(Vec3(0.5f, 0.3f, 1.0f));
  const Bsdf bsdf = sheet.seen_from(viewer);
  const auto sample = bsdf.sample_transmission({0.5f, 0.5f});
  ASSERT_TRUE(sample);
  expect_near(sample->direction, -viewer, 1e-6f);
  expect_near(sample->weight, straight_transmittance(sheet.point, viewer.z), 1e-5f);
  EXPECT_EQ(bsdf.eval_diffuse({0, 0, 1}), Color(0.0f));
}

TEST(Bsdf, OpaqueSurface_TransmitsNothing) {
  Surface wall(Color(1.0f), 0.0f, 0.5f);
  EXPECT_FALSE(wall.seen_from({0, 0, 1}).sample_transmission({0.5f, 0.5f}));
  EXPECT_EQ(straight_transmittance(wall.point, 1.0f), Color(0.0f));
}

TEST(Bsdf, LightFromBelow_GivesNothing) {
  Surface surface(Color(1.0f), 0.3f, 0.5f);
  const Bsdf bsdf = surface.seen_from({0, 0, 1});
  const Vec3 below = glm::normalize(Vec3(0.3f, 0.1f, -0.5f));
  EXPECT_EQ(bsdf.eval_diffuse(below), Color(0.0f));
  EXPECT_EQ(bsdf.eval_specular(below), Color(0.0f));
  EXPECT_EQ(bsdf.reflection_pdf(below), 0.0f);
}

TEST(Bsdf, IorZero_ReflectsEverything) {
  Surface surface(Color(0.5f), 0.0f, 0.0f);
  surface.material.ior = 0.0f;
  const Bsdf bsdf = surface.seen_from({0, 0, 1});
  expect_near(bsdf.sample_reflection({0.5f, 0.5f})->weight, Color(1.0f), 1e-6f);
  expect_near(bsdf.eval_diffuse({0, 0, 1}), Color(0.0f), 1e-6f);
}

TEST(Bsdf, AnyMaterial_StaysFinite) {
  Random random(6);
  for (int i = 0; i < 20000; ++i) {
    const bool extreme = random.uniform() < 0.3f;
    const auto unit = [&] { return extreme ? std::round(random.uniform()) : random.uniform(); };
    Surface surface(Color(unit(), unit(), unit()), unit(), unit(), unit(), unit());
    surface.material.ior = extreme ? 1.0f : random.uniform(1.0f, 3.0f);
    surface.point.specular = unit();
    surface.point.specular_color = Color(unit(), unit(), extreme ? 1e4f : 2.0f * unit());
    Vec3 viewer = random.direction();
    viewer.z = random.uniform() < 0.2f ? 1e-3f : std::abs(viewer.z) + 1e-3f;
    viewer = glm::normalize(viewer);
    const Bsdf bsdf = surface.seen_from(viewer, random.uniform() < 0.5f);
    const Vec3 light = random.direction();
    ASSERT_TRUE(geometry::is_finite(bsdf.eval_diffuse(light) + bsdf.eval_specular(light)));
    ASSERT_TRUE(std::isfinite(bsdf.reflection_pdf(light)));
    for (const auto& sample :
         {bsdf.sample_reflection(random.square()), bsdf.sample_transmission(random.square())}) {
      if (!sample) continue;
      ASSERT_TRUE(geometry::is_finite(sample->weight)) << "case " << i;
      ASSERT_TRUE(geometry::is_finite(sample->direction)) << "case " << i;
      ASSERT_TRUE(std::isfinite(sample->pdf)) << "case " << i;
    }
  }
}

}  // namespace
}  // namespace lume::shading
