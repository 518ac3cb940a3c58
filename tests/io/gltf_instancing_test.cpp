// SPDX-License-Identifier: Apache-2.0
// EXT_mesh_gpu_instancing.
#include "tests/io/gltf_guard.h"
#include "tests/io/gltf_shape_file.h"
#include "tests/support/random.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lume::io {
namespace {

using geometry::DVec3;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

nlohmann::json& attributes(nlohmann::json& json) {
  return json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
}

/// The triangle file whose mesh is placed twice: accessors 3, 4 and 5.
test::GltfFile instanced_file() {
  test::GltfFile file = test::triangle_file();
  const std::size_t translation = file.add_floats({1, 2, 3, 4, 5, 6}, "VEC3", 3);
  const float s = std::sqrt(0.5f);
  const std::size_t rotation = file.add_floats({0, 0, 0, 1, 0, 0, s, s}, "VEC4", 4);
  const std::size_t scale = file.add_floats({2, 2, 2, 1, 3, 1}, "VEC3", 3);
  file.json["extensionsUsed"].push_back("EXT_mesh_gpu_instancing");
  file.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  attributes(file.json) = {{"TRANSLATION", translation}, {"ROTATION", rotation}, {"SCALE", scale}};
  return file;
}

DVec3 placed(const LoadedScene& loaded, std::size_t instance, const DVec3& p) {
  return loaded.scene.origin +
         loaded.scene.world.instances.at(instance).transform.point_to_world(p);
}

TEST(GltfInstancing, EachElement_IsAnInstanceOfOneObject) {
  test::GltfFile file = instanced_file();
  file.json["nodes"][0]["translation"] = {10, 0, 0};
  file.json["nodes"][0]["name"] = "crowd";
  const LoadedScene loaded = test::load_json(file.complete());
  ASSERT_EQ(loaded.scene.world.instances.size(), 2u);
  EXPECT_EQ(loaded.scene.world.objects.size(), 1u);
  EXPECT_EQ(loaded.scene.world.instances[1].name, "crowd");
  EXPECT_EQ(placed(loaded, 0, {1, 0, 0}), DVec3(13, 2, 3));
  // Scaled by 3 along y, turned by a quarter around z, moved.
  EXPECT_LE(length(placed(loaded, 1, {0, 1, 0}) - DVec3(14 - 3, 5, 6)), 1e-6);
  EXPECT_THAT(loaded.notes, IsEmpty());
}

TEST(GltfInstancing, NormalizedRotations_AreRead) {
  test::GltfFile file = instanced_file();
  const std::size_t bytes =
      file.add_accessor<std::int8_t>({0, 0, 0, 127, 0, 0, 90, 90}, 5120, "VEC4", 4);
  file.json["accessors"][bytes]["normalized"] = true;
  attributes(file.json) = {{"ROTATION", bytes}};
  const LoadedScene loaded = test::load_json(file.complete());
  EXPECT_EQ(placed(loaded, 0, {1, 0, 0}), DVec3(1, 0, 0));
  EXPECT_LE(length(placed(loaded, 1, {1, 0, 0}) - DVec3(0, 1, 0)), 1e-6);
}

TEST(GltfInstancing, AttributesOfOthers_OnlyCount) {
  test::GltfFile file = instanced_file();
  attributes(file.json) = {{"_ID", 0}};  // the triangle's three positions
  EXPECT_EQ(test::load_json(file.complete()).scene.world.instances.size(), 3u);
}

TEST(GltfInstancing, ShapeOfTheNode_IsInstancedToo) {
  test::GltfFile file = instanced_file();
  file.json["extensions"]["KHR_implicit_shapes"]["shapes"] = {{{"type", "sphere"}}};
  file.json["nodes"][0]["extensions"]["LUME_shape"] = {{"shape", 0}};
  const LoadedScene loaded = test::load_json(file.complete());
  EXPECT_EQ(loaded.scene.world.objects.size(), 2u);
  EXPECT_EQ(loaded.scene.world.instances.size(), 4u);
}

TEST(GltfInstancing, UselessElements_AreOneNote) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  test::GltfFile file = instanced_file();
  const std::size_t translations =
      file.add_floats({0, 0, 0, nan, 0, 0, 0, 0, 0, 0, 0, 0, 5, 0, 0}, "VEC3", 3);
  const std::size_t scales =
      file.add_floats({1, 1, 1, 1, 1, 1, 0, 1, 1, 1, 1, 1, 1, 1, 1}, "VEC3", 3);
  const std::size_t rotations =
      file.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1}, "VEC4", 4);
  attributes(file.json) = {
      {"TRANSLATION", translations}, {"SCALE", scales}, {"ROTATION", rotations}};
  const LoadedScene loaded = test::load_json(file.complete());
  EXPECT_EQ(loaded.scene.world.instances.size(), 2u);
  EXPECT_EQ(placed(loaded, 1, DVec3(0)), DVec3(5, 0, 0));
  EXPECT_THAT(loaded.notes, ElementsAre(HasSubstr("node 0: instances whose matrix")));
}

TEST(GltfInstancing, ManyElements_AllArrive) {
  constexpr std::size_t k_count = 200'000;
  test::Random random(3);
  std::vector<float> values;
  values.reserve(3 * k_count);
  for (std::size_t i = 0; i < 3 * k_count; ++i) values.push_back(random.uniform(-9.0f, 9.0f));
  test::GltfFile file = instanced_file();
  attributes(file.json) = {{"TRANSLATION", file.add_floats(values, "VEC3", 3)}};
  const tests::TemporaryFolder folder;
  test::write_bytes(folder / "a.glb", file.to_glb());
  const LoadedScene loaded = load_gltf(folder / "a.glb");
  ASSERT_EQ(loaded.scene.world.instances.size(), k_count);
  for (std::size_t i = 0; i < k_count; i += 997) {
    ASSERT_EQ(placed(loaded, i, DVec3(0)),
              DVec3(values[3 * i], values[3 * i + 1], values[3 * i + 2]));
  }
}

class GltfInstancingGuard : public testing::TestWithParam<test::GuardCase> {};

TEST_P(GltfInstancingGuard, BrokenFile_IsSceneErrorWithPointer) {
  test::expect_scene_error(
      instanced_file().complete().patch(nlohmann::json::parse(GetParam().patch)),
      GetParam().pointer);
}

constexpr test::GuardCase k_cases[] = {
    {"NotObject", R"([{"op":"replace","path":"/nodes/0/extensions/EXT_mesh_gpu_instancing",
        "value":[]}])",
     "/nodes/0/extensions/EXT_mesh_gpu_instancing"},
    {"NoAttributes",
     R"([{"op":"remove","path":"/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes"}])",
     "/nodes/0/extensions/EXT_mesh_gpu_instancing"},
    {"EmptyAttributes",
     R"([{"op":"replace","path":"/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes",
          "value":{}}])",
     "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes"},
    {"NoSuchAccessor",
     R"([{"op":"replace","path":"/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/SCALE",
          "value":6}])",
     "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/SCALE"},
    {"AccessorText",
     R"([{"op":"replace","path":"/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/SCALE",
          "value":"5"}])",
     "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/SCALE"},
    {"TranslationOfFour",
     R"([{"op":"replace","path":"/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/TRANSLATION",
          "value":4}])",
     "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/TRANSLATION"},
    {"RotationOfThree",
     R"([{"op":"replace","path":"/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/ROTATION",
          "value":3}])",
     "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/ROTATION"},
    {"ScaleOfIntegers", R"([{"op":"replace","path":"/accessors/5/componentType","value":5122}])",
     "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/SCALE"},
    {"RotationOfPlainIntegers",
     R"([{"op":"replace","path":"/accessors/4/componentType","value":5122}])",
     "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/ROTATION"},
    {"RotationOfUnsigned",
     R"([{"op":"replace","path":"/accessors/4/componentType","value":5123},
         {"op":"add","path":"/accessors/4/normalized","value":true}])",
     "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/ROTATION"},
    {"UnequalCounts", R"([{"op":"replace","path":"/accessors/3/count","value":1}])",
     "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/TRANSLATION"},
    {"UnequalCountOfOthers",
     R"([{"op":"add","path":"/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/_ID",
          "value":0}])",
     "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/_ID"},
};
INSTANTIATE_TEST_SUITE_P(Attributes, GltfInstancingGuard, testing::ValuesIn(k_cases),
                         test::case_name);

}  // namespace
}  // namespace lume::io
