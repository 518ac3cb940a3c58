// SPDX-License-Identifier: Apache-2.0
// LUME_materials_phong and LUME_texture_checker: every property gets to its place.
#include "io/gltf/load_gltf.h"
#include "tests/io/gltf_shape_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace lume::io {
namespace {

using nlohmann::json;
using shading::Color;
using shading::Material;
using shading::Vec2;
using shading::Vec3;
using shading::Vec4;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string k_phong = "LUME_materials_phong";

LoadedScene load_material(const char* extensions) {
  json file = test::triangle_file().complete();
  file["materials"][0]["extensions"] = json::parse(extensions);
  return test::load_json(file);
}

Material material_of(const char* extensions) {
  return load_material(extensions).scene.materials.at(0);
}

LoadedScene load_light(const json& light) {
  json file = test::triangle_file().complete();
  file["extensions"]["KHR_lights_punctual"]["lights"][0] = light;
  return test::load_json(file);
}

/// The triangle file, whose base colour texture is made this.
LoadedScene load_texture(const json& texture) {
  json file = test::triangle_file().complete();
  file["textures"][0] = texture;
  return test::load_json(file);
}

TEST(GltfPhong, EmptyExtension_HasTheDefaults) {
  const LoadedScene loaded = load_material(R"({"LUME_materials_phong": {}})");
  const Material& material = loaded.scene.materials.at(0);
  ASSERT_TRUE(material.phong);
  EXPECT_EQ(material.phong->ambient, 1.0f);
  EXPECT_EQ(material.phong->ambient_color, Color(1));
  EXPECT_EQ(material.phong->diffuse, 1.0f);
  EXPECT_EQ(material.phong->diffuse_color, Color(1));
  EXPECT_EQ(material.phong->specular, 0.0f);
  EXPECT_EQ(material.phong->specular_color, Color(1));
  EXPECT_EQ(material.phong->shininess, 50.0f);
  EXPECT_EQ(material.phong->reflection, 0.0f);
  EXPECT_TRUE(std::isinf(material.phong->glossiness));
  EXPECT_EQ(material.phong->transmission, 0.0f);
  EXPECT_EQ(material.phong->transmission_color, Color(1));
  EXPECT_FALSE(material.phong->fresnel);
  EXPECT_EQ(material.ior, 1.5f);
  EXPECT_THAT(loaded.notes, IsEmpty());
}

TEST(GltfPhong, WithoutExtension_IsNone) {
  const LoadedScene loaded = test::load_json(test::triangle_file().complete());
  EXPECT_FALSE(loaded.scene.materials.at(0).phong);
  EXPECT_FALSE(loaded.scene.lights.at(0).attenuation);
  EXPECT_EQ(loaded.scene.ambient, Color(0));
  EXPECT_FALSE(loaded.scene.background);
  EXPECT_FALSE(loaded.scene.textures.at(0).checker);
}

TEST(GltfPhong, AllOfAMaterial_IsRead) {
  const LoadedScene loaded = load_material(R"({"LUME_materials_phong": {
    "ambientFactor": 0.1, "ambientColor": [0.11, 0.12, 0.13],
    "diffuseFactor": 0.2, "diffuseColor": [0.21, 0.22, 0.23],
    "specularFactor": 0.3, "specularColor": [0.31, 0.32, 0.33],
    "shininess": 120.5, "reflectionFactor": 0.4, "glossiness": 900,
    "transmissionFactor": 0.5, "transmissionColor": [0.51, 0.52, 0.53],
    "ior": 1.7, "fresnel": true, "extras": {"author": "me"}, "extensions": {}}})");
  const Material& material = loaded.scene.materials.at(0);
  ASSERT_TRUE(material.phong);
  EXPECT_EQ(material.phong->ambient, 0.1f);
  EXPECT_EQ(material.phong->ambient_color, Color(0.11f, 0.12f, 0.13f));
  EXPECT_EQ(material.phong->diffuse, 0.2f);
  EXPECT_EQ(material.phong->diffuse_color, Color(0.21f, 0.22f, 0.23f));
  EXPECT_EQ(material.phong->specular, 0.3f);
  EXPECT_EQ(material.phong->specular_color, Color(0.31f, 0.32f, 0.33f));
  EXPECT_EQ(material.phong->shininess, 120.5f);
  EXPECT_EQ(material.phong->reflection, 0.4f);
  EXPECT_EQ(material.phong->glossiness, 900.0f);
  EXPECT_EQ(material.phong->transmission, 0.5f);
  EXPECT_EQ(material.phong->transmission_color, Color(0.51f, 0.52f, 0.53f));
  EXPECT_TRUE(material.phong->fresnel);
  EXPECT_EQ(material.ior, 1.7f);
  EXPECT_THAT(loaded.notes, IsEmpty());
}

TEST(GltfPhong, ReflectionFactor_FollowsSpecularFactorUnlessGiven) {
  EXPECT_EQ(material_of(R"({"LUME_materials_phong": {"specularFactor": 0.6}})").phong->reflection,
            0.6f);
  const Material matte =
      material_of(R"({"LUME_materials_phong": {"specularFactor": 0.6, "reflectionFactor": 0}})");
  EXPECT_EQ(matte.phong->reflection, 0.0f);
  EXPECT_EQ(matte.phong->specular, 0.6f);
}

TEST(GltfPhong, Ior_IsItsOwnBeforeThatOfKhronos) {
  EXPECT_EQ(material_of(R"({"LUME_materials_phong": {},
                            "KHR_materials_ior": {"ior": 1.33}})")
                .ior,
            1.33f);
  EXPECT_EQ(material_of(R"({"LUME_materials_phong": {"ior": 1},
                            "KHR_materials_ior": {"ior": 1.33}})")
                .ior,
            1.0f);
  EXPECT_EQ(material_of(R"({"LUME_materials_phong": {"ior": 2.4},
                            "KHR_materials_ior": {"ior": 0}})")
                .ior,
            2.4f);
}

TEST(GltfPhong, RestOfTheMaterial_KeepsItsPlace) {
  const Material material = material_of(R"({"LUME_materials_phong": {"transmissionFactor": 0.5},
    "KHR_materials_volume": {"attenuationDistance": 3, "attenuationColor": [0.5, 1, 0]}})");
  EXPECT_TRUE(material.base_color_texture);
  EXPECT_EQ(material.attenuation_distance, 3.0f);
  EXPECT_EQ(material.attenuation_color, Color(0.5f, 1, 0));
  EXPECT_TRUE(material.is_solid());  // without a thickness
}

TEST(GltfPhong, Attenuation_IsReadOfPointAndSpot) {
  const json extensions = {{k_phong, {{"attenuation", {0.25, 0.1, 0.01}}}}};
  const LoadedScene point = load_light({{"type", "point"}, {"extensions", extensions}});
  EXPECT_EQ(point.scene.lights.at(0).attenuation, Vec3(0.25f, 0.1f, 0.01f));
  EXPECT_THAT(point.notes, IsEmpty());
  const LoadedScene spot = load_light(
      {{"type", "spot"}, {"spot", json::object()}, {"range", 9}, {"extensions", extensions}});
  EXPECT_EQ(spot.scene.lights.at(0).attenuation, Vec3(0.25f, 0.1f, 0.01f));
  EXPECT_EQ(spot.scene.lights.at(0).range, 9.0f);
}

TEST(GltfPhong, DirectionalLightWithoutAttenuation_IsFine) {
  const json extensions = {{k_phong, json::object()}};
  const LoadedScene loaded = load_light({{"type", "directional"}, {"extensions", extensions}});
  EXPECT_FALSE(loaded.scene.lights.at(0).attenuation);
}

TEST(GltfPhong, AmbientAndBackground_AreThoseOfTheChosenScene) {
  json file = test::triangle_file().complete();
  file["scenes"] = json::parse(R"([
    {"nodes": [0], "extensions": {"LUME_materials_phong": {"ambient": [1, 2, 3]}}},
    {"nodes": [0], "extensions": {"LUME_materials_phong": {"background": [0, 0, 0]}}},
    {"nodes": [0], "extensions": {"LUME_materials_phong":
      {"ambient": [4, 5, 6], "background": [7, 8.5, 9]}}},
    {"nodes": [0]}])");
  const auto load = [&](const char* name) {
    LoadOptions options;
    options.scene = name;
    return test::load_json(file, options).scene;
  };
  EXPECT_EQ(load("0").ambient, Color(1, 2, 3));
  EXPECT_FALSE(load("0").background);
  EXPECT_EQ(load("1").ambient, Color(0));
  EXPECT_EQ(load("1").background, Color(0));
  EXPECT_EQ(load("2").ambient, Color(4, 5, 6));
  EXPECT_EQ(load("2").background, Color(7, 8.5f, 9));
  EXPECT_EQ(load("3").ambient, Color(0));
  EXPECT_FALSE(load("3").background);
}

TEST(GltfChecker, EmptyExtension_HasTheDefaultsAndNeedsNoImage) {
  const LoadedScene loaded =
      load_texture({{"extensions", {{"LUME_texture_checker", json::object()}}}});
  EXPECT_EQ(loaded.scene.materials.at(0).base_color_texture.texture, 0u);
  const shading::Texture& texture = loaded.scene.textures.at(0);
  ASSERT_TRUE(texture.checker);
  EXPECT_THAT(texture.checker->colors, ElementsAre(Vec4(1), Vec4(0, 0, 0, 1)));
  EXPECT_EQ(texture.checker->checks, Vec2(2));
  EXPECT_TRUE(loaded.scene.images.empty());
  EXPECT_THAT(loaded.notes, IsEmpty());
}

TEST(GltfChecker, AllOfIt_IsReadAndTheImageBesideItIsNot) {
  const LoadedScene loaded = load_texture(json::parse(R"({"source": 0, "sampler": 0,
    "extensions": {"LUME_texture_checker":
      {"colors": [[0.1, 0.2, 0.3], [0.4, 0.5, 0.6, 0.7]], "checks": [8, 0.5]}}})"));
  const shading::Texture& texture = loaded.scene.textures.at(0);
  ASSERT_TRUE(texture.checker);
  EXPECT_THAT(texture.checker->colors,
              ElementsAre(Vec4(0.1f, 0.2f, 0.3f, 1), Vec4(0.4f, 0.5f, 0.6f, 0.7f)));
  EXPECT_EQ(texture.checker->checks, Vec2(8, 0.5f));
  EXPECT_TRUE(loaded.scene.images.empty());
}

TEST(GltfChecker, BesideAnImageTexture_BothAreUsed) {
  json file = test::triangle_file().complete();
  file["textures"].push_back({{"extensions", {{"LUME_texture_checker", json::object()}}}});
  file["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 1;
  file["materials"][0]["emissiveTexture"]["index"] = 0;
  const shading::Scene scene = test::load_json(file).scene;
  ASSERT_EQ(scene.textures.size(), 2u);
  EXPECT_TRUE(scene.textures[0].checker);
  EXPECT_FALSE(scene.textures[1].checker);
  EXPECT_EQ(scene.textures[1].image, 0u);
  EXPECT_EQ(scene.images.size(), 1u);
}

TEST(GltfChecker, InPlaceOfUnreadableImage_IsDrawn) {
  const json extensions = {{"KHR_texture_basisu", {{"source", 0}}},
                           {"LUME_texture_checker", json::object()}};
  EXPECT_TRUE(load_texture({{"extensions", extensions}}).scene.textures.at(0).checker);
}

TEST(GltfPhong, Extensions_AreKnownInFull) {
  json file = test::triangle_file().complete();
  file["extensionsRequired"] = {"LUME_materials_phong", "LUME_texture_checker"};
  const LoadedScene loaded = test::load_json(file);
  ASSERT_EQ(loaded.extensions.size(), 3u);
  EXPECT_EQ(loaded.extensions[1].support, Support::full);
  EXPECT_EQ(loaded.extensions[2].support, Support::full);
}

TEST(GltfPhong, MistypedProperty_IsNotedWithTheNearest) {
  json file = test::triangle_file().complete();
  file["materials"][0]["extensions"][k_phong]["shinyness"] = 3;
  file["extensions"]["KHR_lights_punctual"]["lights"][0]["extensions"][k_phong]["atenuation"] = 1;
  file["scenes"][0]["extensions"][k_phong]["back ground"] = 1;
  file["textures"][0]["extensions"]["LUME_texture_checker"]["check"] = 1;
  EXPECT_THAT(
      test::load_json(file).notes,
      testing::UnorderedElementsAre(
          HasSubstr("material 'paint': 'shinyness' is no property of 'LUME_materials_phong' of a "
                    "material and is not read; did you mean shininess?"),
          HasSubstr("light 0: 'atenuation' is no property of 'LUME_materials_phong' of a light and "
                    "is not read; did you mean attenuation?"),
          HasSubstr("did you mean background?"),
          HasSubstr("texture 0: 'check' is no property of 'LUME_texture_checker' and is not read; "
                    "did you mean checks?")));
}

}  // namespace
}  // namespace lume::io
