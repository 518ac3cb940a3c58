// SPDX-License-Identifier: Apache-2.0
// What a file says wrongly in LUME_materials_phong and LUME_texture_checker.
#include "io/error.h"
#include "tests/io/gltf_shape_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>

namespace lume::io {
namespace {

using nlohmann::json;

/// An extension in one of its places, the place of the error in it, and what the error says.
struct PhongCase {
  const char* name;
  const char* extension;
  const char* pointer;
  const char* message;
};

std::ostream& operator<<(std::ostream& out, const PhongCase& test) { return out << test.name; }

std::string case_name(const testing::TestParamInfo<PhongCase>& info) { return info.param.name; }

/// That the triangle file with the extension at this place is refused as the case says.
void expect_refused(const std::string& place, const PhongCase& test) {
  json file = test::triangle_file().complete();
  file[json::json_pointer(place)] = json::parse(test.extension);
  try {
    static_cast<void>(test::load_json(file));
    FAIL() << "the file loads";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::scene);
    EXPECT_THAT(error.what(),
                testing::EndsWith(" at " + place + test.pointer + ": " + test.message));
  }
}

class GltfPhongMaterialGuard : public testing::TestWithParam<PhongCase> {};
class GltfPhongLightGuard : public testing::TestWithParam<PhongCase> {};
class GltfPhongSceneGuard : public testing::TestWithParam<PhongCase> {};
class GltfCheckerGuard : public testing::TestWithParam<PhongCase> {};

TEST_P(GltfPhongMaterialGuard, BadExtension_IsSceneErrorWithPointer) {
  expect_refused("/materials/0/extensions/LUME_materials_phong", GetParam());
}

TEST_P(GltfPhongLightGuard, BadExtension_IsSceneErrorWithPointer) {
  expect_refused("/extensions/KHR_lights_punctual/lights/0/extensions/LUME_materials_phong",
                 GetParam());
}

TEST_P(GltfPhongSceneGuard, BadExtension_IsSceneErrorWithPointer) {
  expect_refused("/scenes/0/extensions/LUME_materials_phong", GetParam());
}

TEST_P(GltfCheckerGuard, BadExtension_IsSceneErrorWithPointer) {
  expect_refused("/textures/0/extensions/LUME_texture_checker", GetParam());
}

constexpr const char* k_no_factor = "is 1.1, expected a number in [0, 1]";
constexpr const char* k_negative = "is -0.1, expected a number in [0, 1]";
constexpr const char* k_no_color = "is 2, expected a number in [0, 1]";
constexpr const char* k_too_large = "is 1e+39, expected a number that a float can hold";

constexpr PhongCase k_material_cases[] = {
    {"Array", R"([])", "", "is an array of 0, expected an object"},
    {"AmbientFactor", R"({"ambientFactor":1.1})", "/ambientFactor", k_no_factor},
    {"AmbientColor", R"({"ambientColor":[0,2,0]})", "/ambientColor/1", k_no_color},
    {"DiffuseFactor", R"({"diffuseFactor":-0.1})", "/diffuseFactor", k_negative},
    {"DiffuseColor", R"({"diffuseColor":[2,0,0]})", "/diffuseColor/0", k_no_color},
    {"DiffuseColorWithAlpha", R"({"diffuseColor":[1,1,1,1]})", "/diffuseColor",
     "is an array of 4, expected an array of 3 numbers"},
    {"SpecularFactor", R"({"specularFactor":1.1})", "/specularFactor", k_no_factor},
    {"SpecularColor", R"({"specularColor":[0,0,2]})", "/specularColor/2", k_no_color},
    {"SpecularColorNumber", R"({"specularColor":1})", "/specularColor",
     "is 1, expected an array of 3 numbers"},
    {"Shininess", R"({"shininess":-1})", "/shininess", "is -1, expected a number of at least 0"},
    {"ShininessHuge", R"({"shininess":1e39})", "/shininess", k_too_large},
    {"ReflectionFactor", R"({"reflectionFactor":1.1})", "/reflectionFactor", k_no_factor},
    {"Glossiness", R"({"glossiness":-1})", "/glossiness", "is -1, expected a number of at least 0"},
    {"GlossinessNull", R"({"glossiness":null})", "/glossiness", "is null, expected a number"},
    {"TransmissionFactor", R"({"transmissionFactor":1.1})", "/transmissionFactor", k_no_factor},
    {"TransmissionColor", R"({"transmissionColor":[2,1,1]})", "/transmissionColor/0", k_no_color},
    {"Ior", R"({"ior":0.9})", "/ior", "is 0.9, expected a number of at least 1"},
    {"IorZero", R"({"ior":0})", "/ior", "is 0, expected a number of at least 1"},
    {"IorText", R"({"ior":"1.5"})", "/ior", "is \"1.5\", expected a number"},
    {"Fresnel", R"({"fresnel":1})", "/fresnel", "is 1, expected true or false"},
};

constexpr PhongCase k_light_cases[] = {
    {"Number", R"(1)", "", "is 1, expected an object"},
    {"AttenuationNumber", R"({"attenuation":1})", "/attenuation",
     "is 1, expected an array of 3 numbers"},
    {"AttenuationShort", R"({"attenuation":[1,0]})", "/attenuation",
     "is an array of 2, expected an array of 3 numbers"},
    {"AttenuationNegative", R"({"attenuation":[1,-2,0]})", "/attenuation/1",
     "is -2, expected a number of at least 0"},
    {"AttenuationHuge", R"({"attenuation":[1,0,1e39]})", "/attenuation/2", k_too_large},
    {"AttenuationZero", R"({"attenuation":[0,0,0]})", "/attenuation",
     "is 0 in all three, expected one above 0"},
};

constexpr PhongCase k_scene_cases[] = {
    {"Text", R"("dark")", "", "is \"dark\", expected an object"},
    {"AmbientNegative", R"({"ambient":[0,0,-1]})", "/ambient/2",
     "is -1, expected a number of at least 0"},
    {"AmbientHuge", R"({"ambient":[1e39,0,0]})", "/ambient/0", k_too_large},
    {"AmbientNumber", R"({"ambient":0.1})", "/ambient", "is 0.1, expected an array of 3 numbers"},
    {"BackgroundNegative", R"({"background":[-1,0,0]})", "/background/0",
     "is -1, expected a number of at least 0"},
    {"BackgroundText", R"({"background":[0,"0",0]})", "/background/1",
     "is \"0\", expected a number"},
    {"BackgroundHuge", R"({"background":[0,1e39,0]})", "/background/1", k_too_large},
};

constexpr PhongCase k_checker_cases[] = {
    {"Boolean", R"(true)", "", "is true, expected an object"},
    {"ColorsObject", R"({"colors":{}})", "/colors", "is an object, expected an array"},
    {"OneColor", R"({"colors":[[1,1,1]]})", "/colors", "has 1 items, expected 2 colours"},
    {"ThreeColors", R"({"colors":[[1,1,1],[1,1,1],[1,1,1]]})", "/colors",
     "has 3 items, expected 2 colours"},
    {"ColorShort", R"({"colors":[[1,1,1],[1,1]]})", "/colors/1", "has 2 numbers, expected 3 or 4"},
    {"ColorLong", R"({"colors":[[1,1,1,1,1],[1,1,1]]})", "/colors/0",
     "has 5 numbers, expected 3 or 4"},
    {"ColorNumber", R"({"colors":[1,0]})", "/colors/0", "is 1, expected an array"},
    {"ColorTooBright", R"({"colors":[[1,1,1],[1,1,1,2]]})", "/colors/1/3", k_no_color},
    {"ChecksNumber", R"({"checks":8})", "/checks", "is 8, expected an array of 2 numbers"},
    {"ChecksZero", R"({"checks":[8,0]})", "/checks/1", "is 0, expected a number in (0, 1e+06]"},
    {"ChecksTooMany", R"({"checks":[2e6,8]})", "/checks/0",
     "is 2000000, expected a number in (0, 1e+06]"},
};

INSTANTIATE_TEST_SUITE_P(Phong, GltfPhongMaterialGuard, testing::ValuesIn(k_material_cases),
                         case_name);
INSTANTIATE_TEST_SUITE_P(Phong, GltfPhongLightGuard, testing::ValuesIn(k_light_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Phong, GltfPhongSceneGuard, testing::ValuesIn(k_scene_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Checker, GltfCheckerGuard, testing::ValuesIn(k_checker_cases), case_name);

std::string message_of(const json& file) {
  try {
    static_cast<void>(test::load_json(file));
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(GltfPhongGuard, AttenuationOfDirectionalLight_IsAnError) {
  json file = test::triangle_file().complete();
  file["extensions"]["KHR_lights_punctual"]["lights"][0] = json::parse(
      R"({"type": "directional",
          "extensions": {"LUME_materials_phong": {"attenuation": [1, 0, 0]}}})");
  EXPECT_THAT(message_of(file),
              testing::HasSubstr("/lights/0/extensions/LUME_materials_phong/attenuation: a "
                                 "directional light has no distance: expected a point or spot"));
}

TEST(GltfPhongGuard, IorZeroOfKhronosAlone_IsAnError) {
  json file = test::triangle_file().complete();
  file["materials"][0]["extensions"] =
      json::parse(R"({"KHR_materials_ior": {"ior": 0}, "LUME_materials_phong": {}})");
  EXPECT_THAT(message_of(file), testing::HasSubstr("/materials/0/extensions/KHR_materials_ior: "));
  EXPECT_THAT(message_of(file), testing::HasSubstr("expected at least 1"));
}

TEST(GltfPhongGuard, WhatIsNotDrawn_IsCheckedToo) {
  json scene = test::triangle_file().complete();
  scene["scenes"].push_back({{"extensions", {{"LUME_materials_phong", {{"ambient", 1}}}}}});
  EXPECT_THAT(message_of(scene), testing::HasSubstr(" at /scenes/1/extensions/"));
  json texture = test::triangle_file().complete();
  texture["textures"].push_back({{"extensions", {{"LUME_texture_checker", {{"checks", 1}}}}}});
  EXPECT_THAT(message_of(texture), testing::HasSubstr(" at /textures/1/extensions/"));
  json light = test::triangle_file().complete();
  light["extensions"]["KHR_lights_punctual"]["lights"].push_back(
      {{"type", "point"}, {"extensions", {{"LUME_materials_phong", {{"attenuation", 1}}}}}});
  EXPECT_THAT(message_of(light), testing::HasSubstr("/lights/1/extensions/"));
}

}  // namespace
}  // namespace lume::io
