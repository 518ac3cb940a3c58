// SPDX-License-Identifier: Apache-2.0
// Nodes at a time of an animation, and what animations may not be. keyframes_test.cpp has the
// interpolations themselves.
#include "tests/io/gltf_guard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace lume::io {
namespace {

using geometry::DVec3;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The triangle file, whose node 0 has a mesh: animation "slide" moves that along x from 1 at 0.5 s
/// to 3 at 1.5 s, animation 1 turns it by a quarter about z within a second, in 16-bit integers.
test::GltfFile animated_file() {
  test::GltfFile file = test::triangle_file();
  const std::size_t times = file.add_floats({0.5f, 1.5f}, "SCALAR", 1);
  const std::size_t places = file.add_floats({1, 0, 0, 3, 0, 0}, "VEC3", 3);
  file.add("animations",
           {{"name", "slide"},
            {"samplers", {{{"input", times}, {"output", places}}}},
            {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}});
  const std::size_t second = file.add_floats({0, 1}, "SCALAR", 1);
  const std::size_t turns =
      file.add_accessor<std::int16_t>({0, 0, 0, 32767, 0, 0, 23170, 23170}, 5122, "VEC4", 4);
  file.json["accessors"][turns]["normalized"] = true;
  file.add("animations",
           {{"samplers", {{{"input", second}, {"output", turns}}}},
            {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}});
  return file;
}

LoadedScene load_at(const nlohmann::json& json, std::optional<double> time,
                    std::optional<std::string> animation = std::nullopt) {
  const tests::TemporaryFolder folder;
  test::write_bytes(folder / "a.gltf", json.dump());
  LoadOptions options;
  options.time = time;
  options.animation = std::move(animation);
  return load_gltf(folder / "a.gltf", options);
}

/// Where the mesh's node has a point of its space, in the world.
DVec3 placed(const LoadedScene& loaded, const DVec3& point) {
  return loaded.scene.origin + loaded.scene.world.instances.at(0).transform.point_to_world(point);
}

void expect_place(const DVec3& actual, const DVec3& expected) {
  EXPECT_LT(length(actual - expected), 1e-4) << actual.x << ' ' << actual.y << ' ' << actual.z;
}

TEST(GltfAnimation, LinearTranslation_IsBetweenItsKeysAndStandsOutsideThem) {
  const nlohmann::json json = animated_file().complete();
  expect_place(placed(load_at(json, 0.0), DVec3(0.0)), {1, 0, 0});
  expect_place(placed(load_at(json, 0.75), DVec3(0.0)), {1.5, 0, 0});
  expect_place(placed(load_at(json, 1.5), DVec3(0.0)), {3, 0, 0});
  expect_place(placed(load_at(json, 99.0), DVec3(0.0)), {3, 0, 0});
}

TEST(GltfAnimation, Step_WaitsForItsKey) {
  nlohmann::json json = animated_file().complete();
  json["animations"][0]["samplers"][0]["interpolation"] = "STEP";
  expect_place(placed(load_at(json, 1.4), DVec3(0.0)), {1, 0, 0});
  expect_place(placed(load_at(json, 1.6), DVec3(0.0)), {3, 0, 0});
}

TEST(GltfAnimation, CubicSpline_FollowsItsTangents) {
  test::GltfFile file = animated_file();
  // In-tangent, value, out-tangent of either key: from 0 with speed 4 to 2 with speed 0.
  const std::size_t rows =
      file.add_floats({0, 0, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0}, "VEC3", 3);
  nlohmann::json json = file.complete();
  json["animations"][0]["samplers"][0]["interpolation"] = "CUBICSPLINE";
  json["animations"][0]["samplers"][0]["output"] = rows;
  // Hermite at the middle: (0 + 2) / 2 + (4 - 0) / 8.
  expect_place(placed(load_at(json, 1.0), DVec3(0.0)), {1.5, 0, 0});
}

TEST(GltfAnimation, Rotation_OfNormalizedIntegersTurns) {
  const nlohmann::json json = animated_file().complete();
  const double half = std::sqrt(0.5);
  expect_place(placed(load_at(json, 0.5, "1"), {1, 0, 0}), {half, half, 0});
  expect_place(placed(load_at(json, 1.0, "animation 1"), {1, 0, 0}), {0, 1, 0});
}

TEST(GltfAnimation, ParentsMotion_CarriesItsChildren) {
  const LoadedScene loaded = load_at(animated_file().complete(), 1.5);
  ASSERT_EQ(loaded.scene.cameras.size(), 1u);  // of node 1, the child of node 0
  expect_place(loaded.scene.origin + DVec3(loaded.scene.cameras[0].position), {3, 0, 0});
}

TEST(GltfAnimation, WithoutATime_NodesStayAndANoteSaysSo) {
  const LoadedScene loaded = load_at(animated_file().complete(), std::nullopt);
  expect_place(placed(loaded, DVec3(0.0)), {0, 0, 0});
  EXPECT_THAT(loaded.notes, ElementsAre(HasSubstr("not played without a time")));
  EXPECT_THAT(load_at(animated_file().complete(), 1.0).notes, IsEmpty());
}

TEST(GltfAnimation, UnknownAnimation_NamesThoseThereAre) {
  for (const char* wanted : {"slid", "2", "-1"}) {
    try {
      static_cast<void>(load_at(animated_file().complete(), 0.0, wanted));
      FAIL() << wanted;
    } catch (const Error& error) {
      EXPECT_EQ(error.pointer(), "/animations");
      EXPECT_THAT(error.reason(), HasSubstr("slide"));
    }
  }
}

TEST(GltfAnimation, FileWithoutAnimations_IsTheSameAtAnyTime) {
  expect_place(placed(load_at(test::triangle_file().complete(), 5.0), DVec3(0.0)), {0, 0, 0});
}

TEST(GltfAnimation, ChannelWithoutANode_IsIgnored) {
  nlohmann::json json = animated_file().complete();
  json["animations"][0]["channels"][0]["target"].erase("node");
  expect_place(placed(load_at(json, 1.5), DVec3(0.0)), {0, 0, 0});
}

class GltfAnimationGuard : public testing::TestWithParam<test::GuardCase> {};

TEST_P(GltfAnimationGuard, BrokenAnimation_IsASceneErrorWithPointer) {
  test::expect_scene_error(
      animated_file().complete().patch(nlohmann::json::parse(GetParam().patch)),
      GetParam().pointer);
}

constexpr test::GuardCase k_guard_cases[] = {
    {"NoInput", R"([{"op":"remove","path":"/animations/0/samplers/0/input"}])",
     "/animations/0/samplers/0"},
    {"InputBeyond", R"([{"op":"replace","path":"/animations/0/samplers/0/input","value":99}])",
     "/animations/0/samplers/0/input"},
    {"InputNotScalar", R"([{"op":"replace","path":"/animations/0/samplers/0/input","value":0}])",
     "/animations/0/samplers/0/input"},
    {"OutputBeyond", R"([{"op":"replace","path":"/animations/0/samplers/0/output","value":99}])",
     "/animations/0/samplers/0/output"},
    {"OutputOfAnotherType",
     R"([{"op":"replace","path":"/animations/0/channels/0/target/path","value":"rotation"}])",
     "/animations/0/samplers/0/output"},
    {"OutputOfAnotherCount",
     R"([{"op":"replace","path":"/animations/0/samplers/0/output","value":0}])",
     "/animations/0/samplers/0/output"},
    {"InterpolationUnknown",
     R"([{"op":"add","path":"/animations/0/samplers/0/interpolation","value":"CUBIC"}])",
     "/animations/0/samplers/0/interpolation"},
    {"SplineOfTooFewRows",
     R"([{"op":"add","path":"/animations/0/samplers/0/interpolation","value":"CUBICSPLINE"}])",
     "/animations/0/samplers/0/output"},
    {"SamplerBeyond", R"([{"op":"replace","path":"/animations/0/channels/0/sampler","value":1}])",
     "/animations/0/channels/0/sampler"},
    {"NoTarget", R"([{"op":"remove","path":"/animations/0/channels/0/target"}])",
     "/animations/0/channels/0"},
    {"NodeBeyond", R"([{"op":"replace","path":"/animations/0/channels/0/target/node","value":9}])",
     "/animations/0/channels/0/target/node"},
    {"TwoChannelsOfAProperty",
     R"([{"op":"add","path":"/animations/0/channels/-",
          "value":{"sampler":0,"target":{"node":0,"path":"translation"}}}])",
     "/animations/0/channels/1/target"},
    {"NodeWithAMatrix",
     R"([{"op":"add","path":"/nodes/0/matrix","value":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}])",
     "/animations/0/channels/0/target/node"},
    {"WeightsWithoutTargets",
     R"([{"op":"replace","path":"/animations/0/channels/0/target/path","value":"weights"}])",
     "/animations/0/channels/0/target/path"},
    {"NameNumber", R"([{"op":"replace","path":"/animations/0/name","value":1}])",
     "/animations/0/name"},
};

INSTANTIATE_TEST_SUITE_P(Animations, GltfAnimationGuard, testing::ValuesIn(k_guard_cases),
                         test::case_name);

TEST(GltfAnimation, KeysThatDoNotGrow_AreAnErrorWhenPlayed) {
  for (const std::vector<float>& times :
       {std::vector<float>{1, 1}, std::vector<float>{2, 1}, std::vector<float>{-1, 1},
        std::vector<float>{0, INFINITY}}) {
    test::GltfFile file = animated_file();
    const std::size_t input = file.add_floats(times, "SCALAR", 1);
    nlohmann::json json = file.complete();
    json["animations"][0]["samplers"][0]["input"] = input;
    try {
      static_cast<void>(load_at(json, 0.5));
      FAIL() << times[0] << ' ' << times[1];
    } catch (const Error& error) {
      EXPECT_EQ(error.pointer(), "/animations/0/samplers/0/input");
    }
  }
}

TEST(GltfAnimation, SampleModels_MoveWithTime) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "LUME_TEST_DATA is not set";
  const auto model = *data / "gltf/assets/BoxAnimated/glTF-Binary/BoxAnimated.glb";
  if (!std::filesystem::exists(model)) GTEST_SKIP() << model << " is not there";
  LoadOptions start;
  start.time = 0.0;
  LoadOptions later;
  later.time = 1.5;
  const auto matrix = [](const LoadedScene& loaded, std::size_t i) {
    return loaded.scene.world.instances.at(i).transform.linear();
  };
  const LoadedScene a = load_gltf(model, start);
  const LoadedScene b = load_gltf(model, later);
  EXPECT_TRUE(matrix(a, 0) != matrix(b, 0) || matrix(a, 1) != matrix(b, 1));
}

}  // namespace
}  // namespace lume::io
