// SPDX-License-Identifier: Apache-2.0
// What a file says of its materials, textures and images.
#include "tests/io/gltf_guard.h"

namespace lume::io {
namespace {

using Case = test::GuardCase;

class GltfMaterialGuard : public testing::TestWithParam<Case> {};

TEST_P(GltfMaterialGuard, BrokenFile_IsSceneErrorWithPointer) {
  test::expect_scene_error(GetParam());
}

constexpr Case k_texture_cases[] = {
    {"NoSuchImage", R"([{"op":"replace","path":"/textures/0/source","value":1}])",
     "/textures/0/source"},
    {"NoSuchSampler", R"([{"op":"replace","path":"/textures/0/sampler","value":1}])",
     "/textures/0/sampler"},
    {"NoSuchTexture",
     R"([{"op":"replace","path":"/materials/0/pbrMetallicRoughness/baseColorTexture/index",
          "value":1}])",
     "/materials/0/pbrMetallicRoughness/baseColorTexture/index"},
    {"WrapMode", R"([{"op":"add","path":"/samplers/0/wrapS","value":1}])", "/samplers/0/wrapS"},
    {"Filter", R"([{"op":"add","path":"/samplers/0/magFilter","value":9984}])",
     "/samplers/0/magFilter"},
    {"ImageFileMissing", R"([{"op":"replace","path":"/images/0/uri","value":"none.png"}])",
     "/images/0/uri"},
    {"ImageIsFolder", R"([{"op":"replace","path":"/images/0/uri","value":"."}])", "/images/0/uri"},
    {"ImageHasNeither", R"([{"op":"replace","path":"/images/0","value":{}}])", "/images/0"},
    {"ImageHasBoth", R"([{"op":"add","path":"/images/0/bufferView","value":0}])", "/images/0"},
    {"ImageNoSuchView", R"([{"op":"replace","path":"/images/0","value":{"bufferView":3}}])",
     "/images/0/bufferView"},
    {"ImageViewBeyondBuffer",
     R"([{"op":"add","path":"/bufferViews/-","value":{"buffer":0,"byteOffset":8,
          "byteLength":2000}},
         {"op":"replace","path":"/images/0","value":{"bufferView":3}}])",
     "/bufferViews/3"},
    {"BasisuAlone",
     R"([{"op":"replace","path":"/textures/0",
          "value":{"name":"wood","extensions":{"KHR_texture_basisu":{"source":0}}}}])",
     "/textures/0"},
    {"WebpNoSuchImage",
     R"([{"op":"add","path":"/textures/0/extensions",
          "value":{"EXT_texture_webp":{"source":4}}}])",
     "/textures/0/extensions/EXT_texture_webp/source"},
};

constexpr Case k_material_cases[] = {
    {"BaseColorAboveOne",
     R"([{"op":"add","path":"/materials/0/pbrMetallicRoughness/baseColorFactor",
          "value":[1,1.5,1,1]}])",
     "/materials/0/pbrMetallicRoughness/baseColorFactor/1"},
    {"BaseColorShort",
     R"([{"op":"add","path":"/materials/0/pbrMetallicRoughness/baseColorFactor",
          "value":[1,1,1]}])",
     "/materials/0/pbrMetallicRoughness/baseColorFactor"},
    {"RoughnessNegative",
     R"([{"op":"add","path":"/materials/0/pbrMetallicRoughness/roughnessFactor","value":-0.1}])",
     "/materials/0/pbrMetallicRoughness/roughnessFactor"},
    {"MetallicText",
     R"([{"op":"add","path":"/materials/0/pbrMetallicRoughness/metallicFactor","value":"1"}])",
     "/materials/0/pbrMetallicRoughness/metallicFactor"},
    {"AlphaMode", R"([{"op":"add","path":"/materials/0/alphaMode","value":"GLASS"}])",
     "/materials/0/alphaMode"},
    {"Cutoff", R"([{"op":"add","path":"/materials/0/alphaCutoff","value":-1}])",
     "/materials/0/alphaCutoff"},
    {"DoubleSided", R"([{"op":"add","path":"/materials/0/doubleSided","value":1}])",
     "/materials/0/doubleSided"},
    {"IorBelowOne",
     R"([{"op":"add","path":"/materials/0/extensions","value":{"KHR_materials_ior":{"ior":0.5}}}])",
     "/materials/0/extensions/KHR_materials_ior/ior"},
    {"Transmission",
     R"([{"op":"add","path":"/materials/0/extensions",
          "value":{"KHR_materials_transmission":{"transmissionFactor":2}}}])",
     "/materials/0/extensions/KHR_materials_transmission/transmissionFactor"},
    {"SpecularAboveOne", R"([{"op":"add","path":"/materials/0/extensions",
          "value":{"KHR_materials_specular":{"specularFactor":1.5}}}])",
     "/materials/0/extensions/KHR_materials_specular/specularFactor"},
    {"SpecularColorNegative", R"([{"op":"add","path":"/materials/0/extensions",
          "value":{"KHR_materials_specular":{"specularColorFactor":[1,-1,1]}}}])",
     "/materials/0/extensions/KHR_materials_specular/specularColorFactor/1"},
    {"AttenuationDistanceZero",
     R"([{"op":"add","path":"/materials/0/extensions",
          "value":{"KHR_materials_volume":{"attenuationDistance":0}}}])",
     "/materials/0/extensions/KHR_materials_volume/attenuationDistance"},
    {"EmissiveStrengthNegative",
     R"([{"op":"add","path":"/materials/0/extensions",
          "value":{"KHR_materials_emissive_strength":{"emissiveStrength":-1}}}])",
     "/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength"},
    {"TransformScale",
     R"([{"op":"add","path":"/materials/0/pbrMetallicRoughness/baseColorTexture/extensions",
          "value":{"KHR_texture_transform":{"scale":[1]}}}])",
     "/materials/0/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/scale"},
    {"TextureCoordinateSet",
     R"([{"op":"add","path":"/materials/0/pbrMetallicRoughness/baseColorTexture/texCoord",
          "value":4000000000}])",
     "/materials/0/pbrMetallicRoughness/baseColorTexture/texCoord"},
};

INSTANTIATE_TEST_SUITE_P(Texture, GltfMaterialGuard, testing::ValuesIn(k_texture_cases),
                         test::case_name);
INSTANTIATE_TEST_SUITE_P(Material, GltfMaterialGuard, testing::ValuesIn(k_material_cases),
                         test::case_name);

}  // namespace
}  // namespace lume::io
