// SPDX-License-Identifier: Apache-2.0
// What the program answers when it is not asked to render: help, versions, and mistakes.
#include "tests/cli/run_lume.h"
#include "tests/support/gltf_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace lume::cli {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using Arguments = std::vector<std::string>;

/// One line on stderr, nothing on stdout, and the exit code.
void expect_error(const tests::TemporaryFolder& folder, const Arguments& arguments, int exit_code,
                  const std::string& message) {
  const Outcome outcome = run_lume(folder, arguments);
  const std::string what = testing::PrintToString(arguments);
  EXPECT_EQ(outcome.exit_code, exit_code) << what << outcome.err;
  EXPECT_EQ(outcome.out, "") << what;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << what << outcome.err;
  EXPECT_THAT(outcome.err, StartsWith("lume: error: ")) << what;
  EXPECT_THAT(outcome.err, HasSubstr(message)) << what;
}

TEST(Usage, Help_GoesToStdout) {
  const tests::TemporaryFolder folder;
  for (const Arguments& arguments :
       {Arguments{"--help"}, Arguments{"render", "--help"}, Arguments{"info", "-h"}}) {
    const Outcome outcome = run_lume(folder, arguments);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.out, HasSubstr("Examples:"));
    EXPECT_EQ(outcome.err, "");
  }
}

TEST(Usage, Version_NamesEveryLibrary) {
  const tests::TemporaryFolder folder;
  const Outcome outcome = run_lume(folder, {"--version"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const char* name : {"lume ", "Embree", "oneTBB", "tinygltf", "OpenImageIO", "OpenColorIO",
                           "glm", "fmt", "spdlog", "CLI11", "nlohmann-json", "instruction set"}) {
    EXPECT_THAT(outcome.out, HasSubstr(name));
  }
}

TEST(Usage, Mistakes_AreOneLineWithASuggestion) {
  const tests::TemporaryFolder folder;
  expect_error(folder, {}, 2, "no subcommand");
  expect_error(folder, {"redner", "a.glb"}, 2, "did you mean 'render'");
  expect_error(folder, {"a.glb"}, 2, "lume render a.glb");
  expect_error(folder, {"render"}, 2, "no scene given");
  expect_error(folder, {"render", "a.glb"}, 2, "no output given");
  expect_error(folder, {"render", "a.glb", "-o"}, 2, "needs a value");
  expect_error(folder, {"render", "a.glb", "--oputput", "a.png"}, 2, "did you mean '--output'");
  expect_error(folder, {"render", "--sp=4", "a.glb", "-o", "a.png"}, 2, "did you mean '--spp'");
  expect_error(folder, {"render", "a.glb", "b.glb", "-o", "a.png"}, 2, "one scene at a time");
  expect_error(folder, {"render", "a.glb", "-o", "a.png", "--filter", "gausian"}, 2,
               "did you mean 'gaussian'");
  expect_error(folder, {"render", "a.glb", "-o", "a.png", "--aov", "depth"}, 2, "EXR");
  expect_error(folder, {"render", "a.glb", "-o", "a.png", "--animation", "walk"}, 2, "--time");
  expect_error(folder, {"render", "a.glb", "-o", "a.png", "--time", "-1"}, 2, "--time");
  expect_error(folder, {"info"}, 2, "no scene given");
  expect_error(folder, {"info", "a.glb", "--jsn"}, 2, "did you mean '--json'");
}

TEST(Usage, FilesThatCannotBeUsed_AreExitFour) {
  const tests::TemporaryFolder folder;
  const std::string scene = test::triangle_file().write(folder / "a.gltf").string();
  expect_error(folder, {"render", "none.glb", "-o", "a.png"}, 4, "none.glb");
  expect_error(folder, {"info", "none.glb"}, 4, "none.glb");
  expect_error(folder, {"render", scene, "-o", "a.xyz"}, 4, ".exr");
  expect_error(folder, {"render", scene, "-o", "none/a.png"}, 4, "none");
  expect_error(folder, {"render", scene, "-o", "a.png", "--stats", "none/a.json"}, 4, "none");
  expect_error(folder, {"render", scene, "-o", "a.png", "--env", "none.hdr"}, 4, "none.hdr");
  expect_error(folder, {"render", scene, "-o", "a.png", "--view", "Standrad"}, 4, "Standard");
}

TEST(Usage, BrokenScene_IsExitThree) {
  const tests::TemporaryFolder folder;
  test::write_bytes(folder / "a.gltf", R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[7]}]})");
  expect_error(folder, {"render", "a.gltf", "-o", "a.png"}, 3, "/scenes/0/nodes/0");
  expect_error(folder, {"info", "a.gltf"}, 3, "/scenes/0/nodes/0");
}

TEST(Info, Json_HoldsTheCounts) {
  const tests::TemporaryFolder folder;
  const std::string scene = test::triangle_file().write(folder / "a.gltf").string();
  const Outcome outcome = run_lume(folder, {"info", scene, "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["counts"]["triangles"], 1);
  EXPECT_EQ(json["counts"]["vertices"], 3);
  EXPECT_EQ(json["counts"]["images"], 1);
  EXPECT_EQ(json["images"][0]["width"], 2);
  EXPECT_EQ(json["images"][0]["bytes"], 8);
  EXPECT_EQ(json["cameras"].size(), 1u);
  EXPECT_EQ(json["lights"][0]["unit"], "cd");
  EXPECT_EQ(json["extensions"][0]["name"], "KHR_lights_punctual");
  EXPECT_EQ(json["bounds"]["upper"], nlohmann::json({1.0, 1.0, 0.0}));
}

TEST(Info, Text_NamesTheUnits) {
  const tests::TemporaryFolder folder;
  const std::string scene = test::triangle_file().write(folder / "a.gltf").string();
  const Outcome outcome = run_lume(folder, {"info", scene});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("683 cd = 1 W/sr"));
  EXPECT_THAT(outcome.out, HasSubstr("paint"));
  EXPECT_THAT(outcome.out, HasSubstr("2x1"));
}

TEST(Info, NamesThatAreNotUtf8_StillGiveJson) {
  const tests::TemporaryFolder folder;
  std::filesystem::copy_file(test::triangle_file().write(folder / "a.gltf"), folder / "\xff.gltf");
  const Outcome outcome = run_lume(folder, {"info", "\xff.gltf", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(nlohmann::json::accept(outcome.out));
}

}  // namespace
}  // namespace lume::cli
