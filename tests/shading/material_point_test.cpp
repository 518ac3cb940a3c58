// SPDX-License-Identifier: Apache-2.0
// Which channel of which texture makes which factor, and in which encoding.
#include "shading/material_point.h"

#include "tests/support/near.h"
#include "tests/support/worlds.h"

#include <gtest/gtest.h>

namespace lume::shading {
namespace {

using test::expect_near;

/// One texel of four different values: linear (0.2, 0.4, 0.6, 0.8).
constexpr std::uint8_t k_texel[] = {51, 102, 153, 204};

/// What the texel's colour is when it is read as sRGB (IEC 61966-2-1).
Color decoded_texel() {
  Color result;
  for (int c = 0; c < 3; ++c) {
    result[c] = std::pow((static_cast<float>(k_texel[c]) / 255.0f + 0.055f) / 1.055f, 2.4f);
  }
  return result;
}

/// The material of a square with that texture, seen from above.
MaterialPoint evaluate(const Material& material) {
  Scene scene;
  scene.materials = {material};
  scene.images.push_back({"", 1, 1, std::vector<std::uint8_t>(k_texel, k_texel + 4)});
  scene.textures.emplace_back();
  scene.world.objects.push_back({"", {{test::square_mesh()}}});
  scene.world.instances.emplace_back();
  const geometry::Ray ray{.origin = {0.1f, 0.2f, 1.0f}, .direction = {0, 0, -1}};
  const geometry::Hit hit{0, 0, 0};
  const geometry::Crossing crossing = refine(scene.world, ray, hit, nullptr);
  return evaluate_material(scene, surface_point(scene.world, ray, hit, crossing), {0, 0, 1});
}

constexpr TextureUse k_use{0, 0, {}};

TEST(MaterialPoint, WithoutTextures_HasTheFactors) {
  Material material;
  material.metallic = 0.3f;
  material.roughness = 0.4f;
  material.transmission = 0.5f;
  material.specular = 0.6f;
  material.specular_color = {2.0f, 1.0f, 0.5f};
  const MaterialPoint point = evaluate(material);
  EXPECT_EQ(point.metallic, 0.3f);
  EXPECT_EQ(point.roughness, 0.4f);
  EXPECT_EQ(point.transmission, 0.5f);
  EXPECT_EQ(point.specular, 0.6f);
  EXPECT_EQ(point.specular_color, Color(2.0f, 1.0f, 0.5f));
  EXPECT_EQ(point.occlusion, 1.0f);
}

TEST(MaterialPoint, Factors_AreMultipliedByTheirChannels) {
  Material material;
  material.metallic = 0.5f;
  material.roughness = 0.5f;
  material.metallic_roughness_texture = k_use;
  material.transmission = 0.5f;
  material.transmission_texture = k_use;
  material.specular = 0.5f;
  material.specular_texture = k_use;
  material.occlusion_texture = k_use;
  material.occlusion_strength = 0.5f;
  const MaterialPoint point = evaluate(material);
  EXPECT_NEAR(point.roughness, 0.5f * 0.4f, 1e-6f);     // G
  EXPECT_NEAR(point.metallic, 0.5f * 0.6f, 1e-6f);      // B
  EXPECT_NEAR(point.transmission, 0.5f * 0.2f, 1e-6f);  // R
  EXPECT_NEAR(point.specular, 0.5f * 0.8f, 1e-6f);      // A
  EXPECT_NEAR(point.occlusion, 1.0f + 0.5f * (0.2f - 1.0f), 1e-6f);
}

TEST(MaterialPoint, Colors_AreDecoded) {
  Material material;
  material.base_color = {0.5f, 1.0f, 1.0f};
  material.base_color_texture = k_use;
  material.specular_color = {1.0f, 2.0f, 1.0f};
  material.specular_color_texture = k_use;
  const MaterialPoint point = evaluate(material);
  expect_near(point.base_color, Color(0.5f, 1.0f, 1.0f) * decoded_texel(), 1e-5f);
  expect_near(point.specular_color, Color(1.0f, 2.0f, 1.0f) * decoded_texel(), 1e-5f);
}

}  // namespace
}  // namespace lume::shading
