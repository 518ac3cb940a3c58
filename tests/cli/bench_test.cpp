// SPDX-License-Identifier: Apache-2.0
// `lume bench` from the outside, over a scene of one triangle and one of a few shapes.
#include "io/ray_file.h"
#include "renderer/cli/bench_modes.h"
#include "renderer/cli/bench_report.h"
#include "renderer/cli/color_map.h"
#include "tests/cli/run_lume.h"
#include "tests/support/gltf_file.h"
#include "tests/support/json_schema.h"
#include "tests/support/liar.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace lume::cli {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Arguments = std::vector<std::string>;

class BenchCommand : public testing::Test {
 protected:
  Outcome bench(const Arguments& more) {
    Arguments arguments = {"bench", scene_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_lume(folder_, arguments);
  }
  /// A race that takes no time.
  Outcome race(const Arguments& more) {
    Arguments arguments = {"--count",        "64",
                           "--repeat",       "2",
                           "--budget",       "0.01",
                           "--width",        "32",
                           "--accelerators", "embree,brute-force"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return bench(arguments);
  }
  void expect_error(const Arguments& more, int exit_code, const std::string& message) {
    const Outcome outcome = bench(more);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, StartsWith("lume: error: "));
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }

  tests::TemporaryFolder folder_;
  std::string scene_ = (tests::source_dir() / "assets/scenes/whitted.gltf").string();
};

TEST_F(BenchCommand, Text_HasTheMachineTheStructuresAndEveryKindOfRay) {
  const Outcome outcome = race({"-q"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const char* part : {"Embree 3", "g++", "whitted.gltf", "structures", "build ms",
                           "primary: closest hit, 64 rays", "shadow: any hit",
                           "diffuse: ", "bounce2: ", "ao: ", "ratio to", "brute-force", "by 16"}) {
    if (std::string(part) == "g++" && outcome.out.find("clang++") != std::string::npos) continue;
    EXPECT_THAT(outcome.out, HasSubstr(part));
  }
}

TEST_F(BenchCommand, Json_IsWhatItsSchemaSays) {
  const Outcome outcome = race({"-q", "--json", "-", "--hit-rate", "50", "--rays", "primary,ao"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  const test::JsonSchema schema(
      json::parse(read_text(tests::source_dir() / "docs/schema/lume_bench.schema.json")));
  EXPECT_TRUE(schema.accepts(report));
  EXPECT_EQ(report["baseline"], "embree");
  EXPECT_EQ(report["settings"]["hit_rate_percent"], 50);
  const json& scene = report["scenes"][0];
  EXPECT_EQ(scene["structures"].size(), 2u);
  ASSERT_EQ(scene["ray_sets"].size(), 2u);
  const json& primary = scene["ray_sets"][0];
  EXPECT_EQ(primary["timings"].size(), 4u);
  EXPECT_EQ(primary["timings"][0]["hits"].get<int>() * 2, primary["rays"].get<int>());
  EXPECT_EQ(primary["timings"][0]["ratio"]["median"], 1.0);
  // The schema says something: a report without its machine, or with a negative rate, is none.
  json broken = report;
  broken.erase("machine");
  EXPECT_FALSE(schema.accepts(broken));
  broken = report;
  broken["scenes"][0]["ray_sets"][0]["timings"][0]["ratio"]["low"] = -1;
  EXPECT_FALSE(schema.accepts(broken));
}

TEST_F(BenchCommand, Files_HoldRowsAndNothingFromOutside) {
  const Outcome outcome = race({"--csv", "a.csv", "--html", "a.html", "--json", "a.json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string csv = read_text(folder_ / "a.csv");
  EXPECT_THAT(csv, StartsWith("scene,structure,rays,query,api,"));
  // Two structures; primary and shadow also in batches.
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * (2 * 2 + 3));
  const auto columns = std::count(csv.begin(), csv.begin() + csv.find('\n'), ',');
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns) << line;
  }
  const std::string html = read_text(folder_ / "a.html");
  EXPECT_THAT(html, AllOf(StartsWith("<!DOCTYPE html>"), HasSubstr("<svg"), HasSubstr("</html>"),
                          HasSubstr("lume bench"), HasSubstr("--html a.html")));
  for (const char* outside :
       {"http://", "https://", "src=", "href=", "url(", "@import", "<script"}) {
    EXPECT_THAT(html, Not(HasSubstr(outside)));
  }
  EXPECT_TRUE(json::accept(read_text(folder_ / "a.json")));
}

TEST_F(BenchCommand, Rays_AreSavedAndShotAgain) {
  const Outcome saved = race({"-q", "--save-rays", "a.rays", "--rays", "shadow,bounce2"});
  ASSERT_EQ(saved.exit_code, 0) << saved.err;
  const auto lists = io::read_rays(folder_ / "a.rays");
  ASSERT_EQ(lists.size(), 2u);
  EXPECT_EQ(lists[0].name, "shadow");
  EXPECT_TRUE(lists[0].any_hit);
  EXPECT_EQ(lists[1].rays.size(), 64u);
  const Outcome loaded = race({"-q", "--load-rays", "a.rays", "--save-rays", "b.rays"});
  ASSERT_EQ(loaded.exit_code, 0) << loaded.err;
  EXPECT_EQ(read_text(folder_ / "a.rays"), read_text(folder_ / "b.rays"));
  EXPECT_THAT(loaded.out, AllOf(HasSubstr("bounce2: "), Not(HasSubstr("primary: "))));
}

TEST_F(BenchCommand, SeveralScenes_HaveSectionsOfTheirOwn) {
  const std::string other = test::triangle_file().write(folder_ / "one.gltf").string();
  const Outcome outcome = race({other, "-q", "--rays", "primary"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("whitted.gltf: "), HasSubstr("one.gltf: ")));
}

TEST_F(BenchCommand, Prove_GivesOneFingerprint) {
  const Outcome outcome =
      bench({"-q", "--prove", "--width", "24", "--accelerators", "embree,embree-high,brute-force"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("all 3 structures agree"));
  std::istringstream lines(outcome.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_THAT(line, HasSubstr("24x"));
  std::vector<std::string> hashes;
  for (int i = 0; i < 3 && std::getline(lines, line); ++i)
    hashes.push_back(line.substr(line.rfind(' ') + 1));
  ASSERT_EQ(hashes.size(), 3u);
  EXPECT_EQ(hashes[0].size(), 32u);
  EXPECT_THAT(hashes, ElementsAre(hashes[0], hashes[0], hashes[0]));
}

TEST_F(BenchCommand, Replay_PrintsHitsInHexadecimal) {
  geometry::Ray ray{.origin = {0.25f, 0.25f, 8.0f}};
  io::write_rays(folder_ / "one.rays", {{"mine", false, false, {ray}}});
  const std::string triangle = test::triangle_file().write(folder_ / "one.gltf").string();
  const Outcome outcome = run_lume(
      folder_, {"bench", triangle, "--replay", "one.rays", "--accelerators", "embree,brute-force"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("ray 0 of mine (closest hit)"));
  EXPECT_THAT(outcome.out, HasSubstr("0x1p-2 0x1p-2 0x1p+3"));
  EXPECT_THAT(outcome.out, HasSubstr("brute-force  closest hit: "));
}

TEST_F(BenchCommand, CostMaps_AreWritten) {
  const Outcome outcome =
      bench({"-q", "--cost-maps", "cost", "--width", "24", "--accelerators", "brute-force"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("cost-brute-force-nodes.png"));
  EXPECT_THAT(read_text(folder_ / "cost-brute-force-nodes.png"), StartsWith("\x89PNG"));
  EXPECT_THAT(read_text(folder_ / "cost-brute-force.exr"), HasSubstr("primitive_tests.V"));
  expect_error({"--cost-maps", "cost", "--accelerators", "embree"}, 2,
               "embree does not count what a ray costs; choose one of");
}

TEST_F(BenchCommand, CostAovs_NeedAStructureThatCounts) {
  const Arguments render = {"render", scene_,  "-q",    "--width", "8",     "--spp",
                            "1",      "--aov", "nodes", "-o",      "a.exr", "--accelerator",
                            "embree"};
  const Outcome refused = run_lume(folder_, render);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--aov: embree does not count"));
  Arguments counting = render;
  counting.insert(counting.end(), {"--accelerator", "brute-force"});
  EXPECT_EQ(run_lume(folder_, counting).exit_code, 0);
  EXPECT_THAT(read_text(folder_ / "a.exr"), HasSubstr("nodes.V"));
  Arguments all = render;
  all[8] = "all";
  EXPECT_EQ(run_lume(folder_, all).exit_code, 0);
}

TEST_F(BenchCommand, Mistakes_AreOneLine) {
  expect_error({"--accelerators", "embree,embre-high"}, 2, "did you mean 'embree-high'");
  expect_error({"--rays", "primry"}, 2, "did you mean 'primary'");
  expect_error({"--hit-rate", "101"}, 2, "--hit-rate");
  expect_error({"--count", "0"}, 2, "--count");
  expect_error({"--prove", "--cost-maps", "a"}, 2, "one at a time");
  expect_error({"--prove", "--csv", "a.csv"}, 2, "are for the race");
  expect_error({"--save-mismatch", "a.rays"}, 2, "needs --prove");
  expect_error({"b.gltf", "--save-rays", "a.rays"}, 2, "of one scene");
  expect_error({"--json", "a", "--csv", "./a"}, 2, "the same file");
  expect_error({"--html", "none/a.html"}, 4, "folder");
  expect_error({"--load-rays", "none.rays", "-q"}, 4, "none.rays: does not exist");
  expect_error({"--count", "64", "--rays", "primary", "--hit-rate", "0", "-q", "--camera", "0",
                "--fov", "1"},
               2, "is impossible, for of 64 primary rays 64 hit something and 0 do not");
  EXPECT_THAT(run_lume(folder_, {"bench"}).err, HasSubstr("no scene given"));
}

TEST(BenchAccelerators, Lists_KeepOrderAndPlugins) {
  EXPECT_THAT(parse_accelerators("brute-force,./mine.so,embree,brute-force"),
              ElementsAre("brute-force", "./mine.so", "embree"));
  const auto all = parse_accelerators("all");
  EXPECT_EQ(all.size(), geometry::accelerator_names().size());
  EXPECT_THROW((void)parse_accelerators("embree,"), UsageError);
}

TEST(BenchDescriptions, PlantedMismatch_IsShownInHexadecimal) {
  shading::Scene scene;
  scene.materials.emplace_back();
  geometry::Mesh mesh;
  mesh.positions = {{-1.0f, -1.0f, 0.0f}, {3.0f, -1.0f, 0.0f}, {-1.0f, 3.0f, 0.0f}};
  mesh.triangles = {{0, 1, 2}};
  scene.world.objects.emplace_back().geometries.push_back({mesh});
  scene.world.instances.emplace_back();
  const renderer::PreparedScene prepared(scene, "embree");
  const test::Liar liar(scene.world, nullptr, [](const geometry::Ray&) { return true; });
  const geometry::Ray ray{.origin = {0.1f, 0.0f, 1.5f}};
  const auto found = renderer::ask_both(prepared.accelerator(), liar, ray, false);
  const std::string text = describe_disagreement(found, "embree", "./mine.so", prepared);
  EXPECT_THAT(text, HasSubstr("origin     0x1.99999ap-4 0x0p+0 0x1.8p+0"));
  EXPECT_THAT(text, HasSubstr("embree     closest hit: instance 0, geometry 0, primitive 0, "
                              "t = 0x1.8p+0 (1.5); any hit: yes"));
  EXPECT_THAT(text, HasSubstr("./mine.so  closest hit: nothing; any hit: no"));
}

TEST(TextTable, Columns_AreAligned) {
  const TextTable table{"title", {"name", "up\ndown"}, {{"ä", "1"}, {"long", "12345"}}};
  EXPECT_EQ(draw_table(table),
            "title\n"
            "           up\n"
            "  name   down\n"
            "  ä         1\n"
            "  long  12345\n");
  EXPECT_THAT(html_table({"a<b", {"x"}, {{"&"}}}),
              AllOf(HasSubstr("a&lt;b"), HasSubstr("<td>&amp;</td>")));
}

/// CIE lightness of a colour (CIE 15:2018), 0 to 100.
float lightness(const shading::Color& color) {
  const float y = 0.2126f * color.x + 0.7152f * color.y + 0.0722f * color.z;
  return 116.0f * std::cbrt(y) - 16.0f;
}

TEST(ColorMap, Sequential_BecomesLighterInEqualSteps) {
  constexpr int k_steps = 64;
  const float all = lightness(sequential_color(1.0f)) - lightness(sequential_color(0.0f));
  EXPECT_GT(all, 60.0f);
  for (int i = 0; i < k_steps; ++i) {
    const float here = lightness(sequential_color(static_cast<float>(i) / k_steps));
    const float next = lightness(sequential_color(static_cast<float>(i + 1) / k_steps));
    EXPECT_GT(next - here, 0.4f * all / k_steps) << i;
    EXPECT_LT(next - here, 2.0f * all / k_steps) << i;
  }
  EXPECT_EQ(sequential_color(-1.0f), sequential_color(0.0f));
  EXPECT_EQ(sequential_color(2.0f), sequential_color(1.0f));
}

TEST(ColorMap, Diverging_IsLightestInTheMiddleAndAsDarkAtBothEnds) {
  EXPECT_GT(lightness(diverging_color(0.0f)), 90.0f);
  for (const float x : {0.25f, 0.5f, 1.0f}) {
    EXPECT_NEAR(lightness(diverging_color(x)), lightness(diverging_color(-x)), 8.0f) << x;
    EXPECT_GT(diverging_color(x).x, diverging_color(x).z);
    EXPECT_LT(diverging_color(-x).x, diverging_color(-x).z);
  }
}

}  // namespace
}  // namespace lume::cli
