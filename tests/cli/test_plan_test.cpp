// SPDX-License-Identifier: Apache-2.0
// What `lume test` knows before it runs anything: which cases, with which options, and what is
// wrong.
#include "renderer/cli/test_plan.h"

#include "renderer/cli/exit_codes.h"
#include "renderer/cli/test_history.h"
#include "tests/cli/test_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace lume::cli {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class TestPlan : public TestFolder {
 protected:
  std::vector<PlannedCase> plan(const std::string& cases, const TestOptions& options = {}) {
    manifest(cases);
    return plan_tests(io::read_manifest(folder_ / "m.toml"), options);
  }

  /// `cases` follows the line "version = 1".
  void expect_error(const std::string& cases, const std::string& message) {
    try {
      (void)plan(cases);
      ADD_FAILURE() << "accepted: " << cases;
    } catch (const io::ManifestError& error) {
      EXPECT_THAT(error.what(),
                  AllOf(StartsWith(folder_ / "m.toml:3: case 'a': render: "), HasSubstr(message)));
    }
  }
};

TEST_F(TestPlan, Options_AreThoseOfRender) {
  const auto plan = this->plan(
      "[defaults]\nrender = \"--spp 4 --width 20 --env ../sky.hdr\"\n"
      "[[case]]\nscene = \"a.gltf\"\nrender = \"--spp 8\"\n");
  ASSERT_EQ(plan.size(), 1u);
  EXPECT_EQ(plan[0].render.scene_file, (folder_ / "a.gltf").string());
  EXPECT_EQ(plan[0].render.spp, 8u);
  EXPECT_EQ(plan[0].render.width, 20);
  EXPECT_EQ(plan[0].render.environment, (folder_ / "../sky.hdr").string());
  EXPECT_EQ(plan[0].picture("actual"), "lume-test-results/a/actual.exr");
}

TEST_F(TestPlan, OptionsThatMakeNoSense_NameTheCase) {
  const std::string scene = "\n[[case]]\nscene = \"a.gltf\"\nrender = ";
  expect_error(scene + "\"--widht 5\"\n", "unknown option '--widht'; did you mean '--width'?");
  expect_error(scene + "\"--width x\"\n", "--width: expected a whole number");
  expect_error(scene + "\"--width\"\n", "--width needs a value");
  expect_error(scene + "\"b.gltf\"\n", "'b.gltf' is no option");
  expect_error(scene + "\"-o b.png\"\n", "-o is not for tests");
  expect_error(scene + "\"--stats=b.json\"\n", "--stats is not for tests");
  expect_error(scene + "\"--quiet\"\n", "--quiet is not for tests");
  expect_error(scene + "\"--help\"\n", "--help is not for tests");
  expect_error(scene + "\"--target 0,0,0\"\n", "--target needs --orbit");
  expect_error(scene + "\"--spp 2\"\nreference = \"a.psd\"\n", "no format");
  expect_error(scene + "\"--aov depth\"\nreference = \"a.png\"\n", "EXR");
}

TEST_F(TestPlan, AcceptCommand_NamesWhatIsToBeDone) {
  const std::string cases = "[[case]]\nname = \"a b\"\nimage = \"a.ppm\"\n";
  TestOptions options;
  options.manifest = "m.toml";
  EXPECT_EQ(plan(cases, options)[0].accept_command,
            "lume test m.toml --filter 'a b' --update missing");
  write_image("references/a b.ppm", 10);
  options.output = "res";
  EXPECT_EQ(plan(cases, options)[0].accept_command,
            "lume test m.toml --filter 'a b' --update changed --output res");
}

TEST(TestFilter, NameGlobOrPart_IsChosen) {
  const std::vector<std::string> names = {"ui-a", "ui-b", "scene", "scene2"};
  EXPECT_THAT(choose_names(names, {}), ElementsAre(true, true, true, true));
  EXPECT_THAT(choose_names(names, {"scene"}), ElementsAre(false, false, true, false));
  EXPECT_THAT(choose_names(names, {"scen"}), ElementsAre(false, false, true, true));
  EXPECT_THAT(choose_names(names, {"*-b"}), ElementsAre(false, true, false, false));
  EXPECT_THAT(choose_names(names, {"scene2", "ui-a"}), ElementsAre(true, false, false, true));
  EXPECT_THROW((void)choose_names(names, {"ui-a", "sceen"}), UsageError);
}

TEST(TestShard, Parts_HoldEachNameOnce) {
  for (const std::uint64_t count : {1u, 2u, 3u, 7u}) {
    std::vector<std::size_t> sizes(count, 0);
    for (int i = 0; i < 1000; ++i) {
      int parts = 0;
      for (std::uint64_t part = 1; part <= count; ++part) {
        if (!is_in_shard("case-" + std::to_string(i), {part, count})) continue;
        ++parts;
        ++sizes[part - 1];
      }
      EXPECT_EQ(parts, 1);
    }
    // Binomial: six standard deviations from an even share.
    const double share = 1000.0 / static_cast<double>(count);
    for (const std::size_t size : sizes) {
      EXPECT_NEAR(static_cast<double>(size), share, 6.0 * std::sqrt(share) + 1e-9) << count;
    }
  }
}

TEST(TestShard, Part_DependsOnTheNameAlone) {
  // Fixed for good: machines of one run may have other versions of Lume.
  std::string parts;
  for (const char* name : {"cornell", "teapot", "museum", "whitted", "gems", "glass"}) {
    for (std::uint64_t part = 1; part <= 4; ++part) {
      if (is_in_shard(name, {part, 4})) parts += std::to_string(part);
    }
  }
  EXPECT_EQ(parts, "342421");
}

TEST_F(TestPlan, Shards_PartitionTheCases) {
  std::string cases;
  for (int i = 0; i < 12; ++i) {
    cases += "[[case]]\nimage = \"i" + std::to_string(i) + ".ppm\"\n";
  }
  std::multiset<std::string> seen;
  for (std::uint64_t part = 1; part <= 3; ++part) {
    TestOptions options;
    options.shard = {part, 3};
    for (const PlannedCase& planned : plan(cases, options)) seen.insert(planned.test.name);
  }
  EXPECT_EQ(seen.size(), 12u);
  EXPECT_EQ(std::set<std::string>(seen.begin(), seen.end()).size(), 12u);
}

class HistoryFile : public TestFolder {
 protected:
  TestHistory read_again(const TestHistory& history) {
    history.write(folder_ / "h.json");
    std::string warning;
    TestHistory again = TestHistory::read(folder_ / "h.json", warning);
    EXPECT_EQ(warning, "");
    return again;
  }
};

TEST_F(HistoryFile, Series_BeginsWithItsFirstFailure) {
  TestHistory history;
  const auto run = [&](const std::string& date, bool failed) {
    history.add_run(date, {{"a", failed ? "failed" : "passed", failed}, {"b", "flaky", true}});
    history = read_again(history);
  };
  run("1", true);
  EXPECT_EQ(history.of("a").failing_since, "1");
  run("2", false);
  EXPECT_EQ(history.of("a").failing_since, "");
  run("3", true);
  run("4", true);
  history.add_run("5", {{"b", "passed", false}});
  const CaseHistory a = history.of("a");
  EXPECT_EQ(a.failing_since, "3");
  EXPECT_EQ(a.failures, 3u);
  EXPECT_EQ(a.runs, 4u);
  EXPECT_EQ(history.of("b").failing_since, "");
  EXPECT_EQ(history.of("b").failures, 4u);
  EXPECT_EQ(history.of("c").runs, 0u);
}

TEST_F(HistoryFile, OldRuns_AreForgottenButNotSinceWhen) {
  TestHistory history;
  for (int i = 0; i < 70; ++i) history.add_run(std::to_string(i), {{"a", "failed", true}});
  history = read_again(history);
  EXPECT_EQ(history.of("a").runs, 50u);
  EXPECT_EQ(history.of("a").failing_since, "0");
}

TEST_F(HistoryFile, BrokenFiles_BeginAnewWithAWarning) {
  for (const char* text :
       {"", "{", "[]", "{\"version\": 2}", "{\"version\": 1, \"runs\": 5, \"failing_since\": {}}",
        "{\"version\": 1, \"runs\": [{\"date\": 1}], \"failing_since\": {}}",
        "{\"version\": 1, \"runs\": [], \"failing_since\": {\"a\": 1}}"}) {
    test::write_bytes(folder_ / "h.json", text);
    std::string warning;
    EXPECT_EQ(TestHistory::read(folder_ / "h.json", warning).of("a").runs, 0u);
    EXPECT_THAT(warning, HasSubstr("it begins anew")) << text;
  }
}

}  // namespace
}  // namespace lume::cli
