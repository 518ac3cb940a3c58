// SPDX-License-Identifier: Apache-2.0
// Each rule is broken in one place of a good file; the finding must name rule and place.
#include "io/check/check_scene.h"

#include "io/check/references.h"
#include "io/error.h"
#include "tests/support/gltf_file.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

namespace lume::io::check {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// The triangle file with what a flawless one has besides.
nlohmann::json flawless() {
  test::GltfFile file = test::triangle_file();
  const std::size_t normals = file.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
  nlohmann::json json = file.complete();
  json["accessors"][0]["min"] = {0, 0, 0};
  json["accessors"][0]["max"] = {1, 1, 0};
  json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = normals;
  return json;
}

std::vector<Finding> check_json(const nlohmann::json& json) {
  const tests::TemporaryFolder folder;
  test::write_bytes(folder / "a.gltf", json.dump());
  return check_scene(folder / "a.gltf");
}

std::string describe(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += finding.code + " at " + finding.pointer + ": " + finding.message + "\n";
  }
  return text;
}

TEST(CheckScene, FlawlessFile_FindsNothing) {
  const std::vector<Finding> findings = check_json(flawless());
  EXPECT_THAT(findings, IsEmpty()) << describe(findings);
}

struct RuleCase {
  const char* name;
  const char* patch;  ///< JSON Patch (RFC 6902) to the flawless file
  const char* code;
  const char* pointer;
};

std::ostream& operator<<(std::ostream& out, const RuleCase& test) { return out << test.name; }

std::string rule_name(const testing::TestParamInfo<RuleCase>& info) { return info.param.name; }

class CheckRule : public testing::TestWithParam<RuleCase> {};

TEST_P(CheckRule, BrokenFile_IsFoundAtItsPlaceAndNothingElse) {
  const std::vector<Finding> findings =
      check_json(flawless().patch(nlohmann::json::parse(GetParam().patch)));
  ASSERT_EQ(findings.size(), 1u) << describe(findings);
  EXPECT_EQ(findings[0].code, GetParam().code);
  EXPECT_EQ(findings[0].pointer, GetParam().pointer);
  EXPECT_FALSE(findings[0].message.empty());
  EXPECT_FALSE(findings[0].advice.empty());
}

constexpr RuleCase k_cases[] = {
    {"Refused", R"([{"op":"replace","path":"/accessors/0/count","value":4}])", "refused",
     "/accessors/0"},
    {"BrokenImage",
     R"([{"op":"replace","path":"/images/0/uri","value":"data:image/png;base64,iVBORw0KGgo="}])",
     "unreadable", "/images/0"},
    {"BoundsMissing", R"([{"op":"remove","path":"/accessors/0/min"}])", "bounds-missing",
     "/accessors/0"},
    {"BoundsWrong", R"([{"op":"replace","path":"/accessors/0/max","value":[1,2,0]}])",
     "bounds-wrong", "/accessors/0"},
    {"MissingNormals",
     R"([{"op":"remove","path":"/meshes/0/primitives/0/attributes/NORMAL"},
         {"op":"remove","path":"/accessors/3"},{"op":"remove","path":"/bufferViews/3"}])",
     "missing-normals", "/meshes/0/primitives/0/attributes"},
    {"MissingTexcoord",
     R"([{"op":"add","path":"/materials/0/pbrMetallicRoughness/baseColorTexture/texCoord","value":1},
         {"op":"add","path":"/meshes/0/primitives/0/attributes/_TEXCOORD_0","value":2}])",
     "missing-texcoord", "/meshes/0/primitives/0/attributes"},
    {"MissingTangents",
     R"([{"op":"add","path":"/materials/0/normalTexture","value":{"index":0}},
         {"op":"remove","path":"/materials/0/pbrMetallicRoughness"}])",
     "missing-tangents", "/meshes/0/primitives/0/attributes"},
    {"BlendWithoutAlpha",
     R"([{"op":"replace","path":"/materials/0","value":{"alphaMode":"BLEND"}},
         {"op":"remove","path":"/textures"},{"op":"remove","path":"/images"},
         {"op":"remove","path":"/samplers"}])",
     "blend-without-alpha", "/materials/0/alphaMode"},
    {"ThinGlass",
     R"([{"op":"add","path":"/materials/0/extensions",
          "value":{"KHR_materials_transmission":{"transmissionFactor":1}}},
         {"op":"add","path":"/materials/0/pbrMetallicRoughness/metallicFactor","value":0},
         {"op":"add","path":"/extensionsUsed/-","value":"KHR_materials_transmission"}])",
     "thin-glass", "/materials/0"},
    {"GlowOff", R"([{"op":"add","path":"/materials/0/emissiveTexture","value":{"index":0}}])",
     "glow-off", "/materials/0/emissiveTexture"},
    {"Watts",
     R"([{"op":"add","path":"/extensions/KHR_lights_punctual/lights/0/intensity",
          "value":54351.41306588226}])",
     "light-units", "/extensions/KHR_lights_punctual/lights/0/intensity"},
    {"BrightLamp",
     R"([{"op":"add","path":"/extensions/KHR_lights_punctual/lights/0/intensity","value":20000}])",
     "light-units", "/extensions/KHR_lights_punctual/lights/0/intensity"},
    {"BrightSun",
     R"([{"op":"replace","path":"/extensions/KHR_lights_punctual/lights/0",
          "value":{"type":"directional","intensity":683000}}])",
     "light-units", "/extensions/KHR_lights_punctual/lights/0/intensity"},
    {"Millimetres", R"([{"op":"add","path":"/nodes/0/scale","value":[1e5,1e5,1e5]}])", "scale", ""},
    {"NoLight",
     R"([{"op":"remove","path":"/extensions"},{"op":"remove","path":"/extensionsUsed"},
         {"op":"remove","path":"/nodes/2/extensions"}])",
     "no-light", ""},
    {"UnusedMaterial", R"([{"op":"add","path":"/materials/-","value":{}}])", "unused-data",
     "/materials/1"},
    {"UnusedNode", R"([{"op":"add","path":"/nodes/-","value":{}}])", "unused-data", "/nodes/3"},
    {"ExtensionUnknown", R"([{"op":"add","path":"/extensionsUsed/-","value":"ACME_gloss"},
         {"op":"add","path":"/materials/0/extensions","value":{"ACME_gloss":{}}}])",
     "extension-ignored", "/materials/0/extensions/ACME_gloss"},
    {"ExtensionUndeclared",
     R"([{"op":"add","path":"/materials/0/extensions","value":{"KHR_materials_ior":{}}}])",
     "extension-undeclared", "/materials/0/extensions/KHR_materials_ior"},
    {"ExtensionUnused", R"([{"op":"add","path":"/extensionsUsed/-","value":"KHR_materials_ior"}])",
     "extension-unused", "/extensionsUsed"},
    {"ExtensionTwice", R"([{"op":"add","path":"/extensionsUsed/-","value":"KHR_lights_punctual"}])",
     "extension-twice", "/extensionsUsed/1"},
    {"ExtensionMisplaced",
     R"([{"op":"add","path":"/scenes/0/extensions","value":{"KHR_lights_punctual":{"light":0}}}])",
     "extension-misplaced", "/scenes/0/extensions/KHR_lights_punctual"},
    {"EmptyArray", R"([{"op":"add","path":"/skins","value":[]}])", "empty-array", "/skins"},
    {"RotationNotUnit", R"([{"op":"add","path":"/nodes/0/rotation","value":[0,0,0,2]}])",
     "rotation-not-unit", "/nodes/0/rotation"},
    {"AttributeUnknown",
     R"([{"op":"add","path":"/meshes/0/primitives/0/attributes/UNKNOWN","value":2}])",
     "attribute-unknown", "/meshes/0/primitives/0/attributes"},
    {"FloatNormalized", R"([{"op":"add","path":"/accessors/3/normalized","value":true}])",
     "accessor-normalized", "/accessors/3/normalized"},
};

INSTANTIATE_TEST_SUITE_P(Rules, CheckRule, testing::ValuesIn(k_cases), rule_name);

TEST(CheckScene, NormalsOfAnyLength_AreFoundOnce) {
  test::GltfFile file = test::triangle_file();
  const std::size_t normals = file.add_floats({0, 0, 2, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
  nlohmann::json json = file.complete();
  json["accessors"][0]["min"] = {0, 0, 0};
  json["accessors"][0]["max"] = {1, 1, 0};
  json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = normals;
  const std::vector<Finding> findings = check_json(json);
  ASSERT_EQ(findings.size(), 1u) << describe(findings);
  EXPECT_EQ(findings[0].code, "normal-not-unit");
  EXPECT_EQ(findings[0].pointer, "/accessors/3");
}

TEST(CheckScene, SameFindingInManyPlaces_IsOneWithACount) {
  nlohmann::json json = flawless();
  for (int i = 0; i < 5; ++i) json["materials"].push_back(nlohmann::json::object());
  const std::vector<Finding> findings = check_json(json);
  ASSERT_EQ(findings.size(), 1u) << describe(findings);
  EXPECT_EQ(findings[0].count, 5u);
  EXPECT_EQ(findings[0].pointer, "/materials/1");
}

TEST(CheckScene, Findings_StandWithTheWorstFirst) {
  nlohmann::json json = flawless();
  json["materials"].push_back(nlohmann::json::object());  // advice
  json["accessors"][0].erase("min");                      // warning
  const std::vector<Finding> findings = check_json(json);
  ASSERT_EQ(findings.size(), 2u) << describe(findings);
  EXPECT_EQ(findings[0].severity, Severity::warning);
  EXPECT_EQ(findings[1].severity, Severity::advice);
}

TEST(CheckScene, AbsentFile_IsAnError) {
  EXPECT_THROW(static_cast<void>(check_scene("no/such/file.gltf")), Error);
}

TEST(References, OfAPrimitive_AreItsAccessorsAndMaterialButNotDracosNumbers) {
  const auto mesh = nlohmann::json::parse(R"({"primitives":[{
      "attributes":{"POSITION":4,"NORMAL":5},"indices":6,"material":1,"mode":4,
      "targets":[{"POSITION":7}],"extras":{"material":9},
      "extensions":{"KHR_draco_mesh_compression":{"bufferView":2,"attributes":{"POSITION":0}}}}]})");
  EXPECT_THAT(
      references_of("meshes", mesh),
      UnorderedElementsAre(Part{"accessors", 4}, Part{"accessors", 5}, Part{"accessors", 6},
                           Part{"accessors", 7}, Part{"materials", 1}, Part{"bufferViews", 2}));
}

TEST(References, OfNodesAndTextures_AreFollowedByTheirKeys) {
  EXPECT_THAT(
      references_of("nodes", nlohmann::json::parse(R"({"mesh":3,"children":[1,2],"skin":0})")),
      UnorderedElementsAre(Part{"meshes", 3}, Part{"nodes", 1}, Part{"nodes", 2},
                           Part{"skins", 0}));
  EXPECT_THAT(references_of("textures", nlohmann::json::parse(R"({"source":3,"sampler":1,
      "extensions":{"EXT_texture_webp":{"source":2}}})")),
              UnorderedElementsAre(Part{"images", 3}, Part{"samplers", 1}, Part{"images", 2}));
}

TEST(References, TextureInfos_HaveTheSetOfTheTransform) {
  const auto infos = texture_infos(nlohmann::json::parse(R"({"normalTexture":{"index":2,
      "texCoord":1,"extensions":{"KHR_texture_transform":{"texCoord":3}}}})"));
  ASSERT_EQ(infos.size(), 1u);
  EXPECT_EQ(infos[0].key, "normalTexture");
  EXPECT_EQ(infos[0].texture, 2u);
  EXPECT_EQ(infos[0].texcoord, 3u);
}

}  // namespace
}  // namespace lume::io::check
