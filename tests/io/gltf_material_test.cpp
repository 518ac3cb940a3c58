// SPDX-License-Identifier: Apache-2.0
#include "io/error.h"
#include "io/gltf/load_gltf.h"
#include "tests/support/gltf_file.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lume::io {
namespace {

using shading::Color;
using shading::Material;
using shading::Vec2;
using test::GltfFile;
using testing::ElementsAre;
using testing::HasSubstr;

LoadedScene load(const GltfFile& file, const LoadOptions& options = {}) {
  const tests::TemporaryFolder folder;
  return load_gltf(file.write(folder / "a.gltf"), options);
}

/// The triangle file with this material and one more texture.
LoadedScene load_material(const char* json) {
  GltfFile file = test::triangle_file();
  file.json["materials"][0] = nlohmann::json::parse(json);
  file.json["textures"].push_back({{"source", 0}, {"sampler", 1}});
  file.json["samplers"].push_back({{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
  return load(file);
}

TEST(GltfMaterial, Defaults_AreThoseOfTheSpecification) {
  const LoadedScene loaded = load_material("{}");
  const Material& material = loaded.scene.materials.at(0);
  EXPECT_EQ(material.name, "material 0");
  EXPECT_EQ(material.base_color, Color(1));
  EXPECT_EQ(material.metallic, 1.0f);
  EXPECT_EQ(material.roughness, 1.0f);
  EXPECT_EQ(material.emission, Color(0));
  EXPECT_EQ(material.alpha_mode, shading::AlphaMode::opaque);
  EXPECT_EQ(material.alpha_cutoff, 0.5f);
  EXPECT_EQ(material.ior, 1.5f);
  EXPECT_FALSE(material.double_sided || material.unlit || material.base_color_texture);
  EXPECT_TRUE(loaded.scene.textures.empty());  // what nobody uses is not loaded
  EXPECT_TRUE(loaded.scene.images.empty());
}

TEST(GltfMaterial, AllOfCore_IsRead) {
  const LoadedScene loaded = load_material(R"({
    "name": "paint", "doubleSided": true, "alphaMode": "MASK", "alphaCutoff": 0.25,
    "pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 0.5,
      "roughnessFactor": 0.6, "baseColorTexture": {"index": 1, "texCoord": 1},
      "metallicRoughnessTexture": {"index": 0}},
    "normalTexture": {"index": 0, "scale": -2, "texCoord": 2},
    "occlusionTexture": {"index": 1, "strength": 0.7},
    "emissiveTexture": {"index": 0}, "emissiveFactor": [1, 0.5, 0]})");
  const Material& material = loaded.scene.materials.at(0);
  EXPECT_EQ(material.base_color, Color(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(material.alpha, 0.4f);
  EXPECT_EQ(material.metallic, 0.5f);
  EXPECT_EQ(material.roughness, 0.6f);
  EXPECT_EQ(material.base_color_texture.texture, 0u);  // numbered by first use
  EXPECT_EQ(material.base_color_texture.texcoord, 1u);
  EXPECT_EQ(material.metallic_roughness_texture.texture, 1u);
  EXPECT_EQ(material.normal_texture.texture, 1u);
  EXPECT_EQ(material.normal_texture.texcoord, 2u);
  EXPECT_EQ(material.normal_scale, -2.0f);
  EXPECT_EQ(material.occlusion_texture.texture, 0u);
  EXPECT_EQ(material.occlusion_strength, 0.7f);
  EXPECT_EQ(material.emission_texture.texture, 1u);
  EXPECT_EQ(material.emission, Color(1, 0.5f, 0));
  EXPECT_EQ(material.alpha_mode, shading::AlphaMode::mask);
  EXPECT_EQ(material.alpha_cutoff, 0.25f);
  EXPECT_TRUE(material.double_sided);
  ASSERT_EQ(loaded.scene.textures.size(), 2u);
  EXPECT_EQ(loaded.scene.textures[0].wrap_u, shading::Wrap::clamp_to_edge);
  EXPECT_EQ(loaded.scene.textures[0].wrap_v, shading::Wrap::mirrored_repeat);
  EXPECT_EQ(loaded.scene.textures[0].filter, shading::Filter::nearest);
  EXPECT_EQ(loaded.scene.textures[1].wrap_u, shading::Wrap::repeat);
  EXPECT_EQ(loaded.scene.textures[1].filter, shading::Filter::linear);
  EXPECT_EQ(loaded.scene.images.size(), 1u);  // shared by both
}

TEST(GltfMaterial, Extensions_AreRead) {
  const Material material = load_material(R"({
    "emissiveFactor": [1, 0.5, 0], "extensions": {
      "KHR_materials_emissive_strength": {"emissiveStrength": 5000000000},
      "KHR_materials_unlit": {}, "KHR_materials_ior": {"ior": 1.33},
      "KHR_materials_transmission": {"transmissionFactor": 0.75,
        "transmissionTexture": {"index": 0}},
      "KHR_materials_specular": {"specularFactor": 0.5, "specularTexture": {"index": 0},
        "specularColorFactor": [2, 1, 0], "specularColorTexture": {"index": 0, "texCoord": 1}},
      "KHR_materials_volume": {"thicknessFactor": 2, "attenuationDistance": 3,
        "attenuationColor": [0.5, 1, 0]}}})")
                                .scene.materials.at(0);
  EXPECT_EQ(material.emission, Color(5e9f, 2.5e9f, 0));
  EXPECT_TRUE(material.unlit);
  EXPECT_EQ(material.ior, 1.33f);
  EXPECT_EQ(material.transmission, 0.75f);
  EXPECT_TRUE(material.transmission_texture);
  EXPECT_EQ(material.specular, 0.5f);
  EXPECT_TRUE(material.specular_texture);
  EXPECT_EQ(material.specular_color, Color(2, 1, 0));
  EXPECT_EQ(material.specular_color_texture.texcoord, 1u);
  EXPECT_EQ(material.thickness, 2.0f);
  EXPECT_EQ(material.attenuation_distance, 3.0f);
  EXPECT_EQ(material.attenuation_color, Color(0.5f, 1, 0));
}

TEST(GltfMaterial, IorZero_IsAllowed) {
  const LoadedScene loaded = load_material(R"({"extensions": {"KHR_materials_ior": {"ior": 0}}})");
  EXPECT_EQ(loaded.scene.materials[0].ior, 0.0f);
}

TEST(GltfMaterial, TextureTransform_OverridesTheSet) {
  const LoadedScene loaded = load_material(R"({"pbrMetallicRoughness": {
    "baseColorTexture": {"index": 0, "texCoord": 1, "extensions": {"KHR_texture_transform":
      {"offset": [0.25, -1], "rotation": 1.5, "scale": [2, 3], "texCoord": 3}}},
    "metallicRoughnessTexture": {"index": 0, "texCoord": 1, "extensions":
      {"KHR_texture_transform": {}}}}})");
  const shading::TextureUse& use = loaded.scene.materials.at(0).base_color_texture;
  EXPECT_EQ(use.texcoord, 3u);
  EXPECT_EQ(use.transform.offset, Vec2(0.25f, -1));
  EXPECT_EQ(use.transform.rotation, 1.5f);
  EXPECT_EQ(use.transform.scale, Vec2(2, 3));
  const shading::TextureUse& other = loaded.scene.materials.at(0).metallic_roughness_texture;
  EXPECT_EQ(other.texcoord, 1u);
  EXPECT_EQ(other.transform.scale, Vec2(1));
}

TEST(GltfImage, IsDecodedFromDataUri) {
  const shading::Image image = load(test::triangle_file()).scene.images.at(0);
  EXPECT_EQ(image.name, "image 0");
  EXPECT_EQ(image.width, 2);
  EXPECT_EQ(image.height, 1);
  EXPECT_THAT(std::get<std::vector<std::uint8_t>>(image.texels),
              ElementsAre(255, 128, 0, 255, 0, 64, 255, 128));
}

TEST(GltfImage, WithoutDecoding_HasOnlyItsSize) {
  const LoadedScene loaded = load(test::triangle_file(), {.scene = {}, .decode_images = false});
  EXPECT_EQ(loaded.scene.images.at(0).width, 2);
  EXPECT_EQ(loaded.scene.images.at(0).memory_bytes(), 0u);
}

TEST(GltfImage, Ktx2_IsRefusedByName) {
  GltfFile file = test::triangle_file();
  file.json["images"][0] = {{"name", "bark"},
                            {"uri", "data:;base64," + test::base64_encode({0xAB, 'K', 'T', 'X', ' ',
                                                                           '2', '0', 0xBB, 13})}};
  EXPECT_THAT([&] { load(file); },
              testing::ThrowsMessage<Error>(HasSubstr("/images/0: image 'bark' is KTX2")));
}

TEST(GltfTexture, BasisuWithFallback_UsesIt) {
  GltfFile file = test::triangle_file();
  file.json["textures"][0]["extensions"]["KHR_texture_basisu"]["source"] = 0;
  EXPECT_EQ(load(file).scene.images.size(), 1u);
}

TEST(GltfTexture, WithoutSource_IsNoTexture) {
  GltfFile file = test::triangle_file();
  file.json["textures"][0] = nlohmann::json::object();
  EXPECT_FALSE(load(file).scene.materials[0].base_color_texture);
}

TEST(GltfExtension, Uses_AreListedWithSupport) {
  GltfFile file = test::triangle_file();
  file.json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_materials_sheen", "ACME_glow"};
  file.json["extensionsRequired"] = {"KHR_texture_transform"};
  const LoadedScene loaded = load(file);
  ASSERT_EQ(loaded.extensions.size(), 4u);
  EXPECT_EQ(loaded.extensions[0].support, Support::full);
  EXPECT_EQ(loaded.extensions[1].support, Support::ignored);
  EXPECT_FALSE(loaded.extensions[1].remark.empty());
  EXPECT_EQ(loaded.extensions[2].support, Support::ignored);
  EXPECT_TRUE(loaded.extensions[3].required);
  EXPECT_THAT(loaded.notes, ElementsAre(HasSubstr("KHR_materials_sheen: not supported yet"),
                                        HasSubstr("ACME_glow: is not known")));
}

TEST(GltfExtension, MistypedRequired_NamesTheNearest) {
  GltfFile file = test::triangle_file();
  file.json["extensionsRequired"] = {"KHR_texture_transfrom"};
  EXPECT_THAT([&] { load(file); }, testing::ThrowsMessage<Error>(
                                       HasSubstr("nearest it knows is KHR_texture_transform")));
}

}  // namespace
}  // namespace lume::io
