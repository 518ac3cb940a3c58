// SPDX-License-Identifier: Apache-2.0
// `lume test` from the outside: how cases come to their verdicts.
#include "tests/cli/test_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <string>

namespace lume::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class TestCommand : public TestFolder {};

TEST_F(TestCommand, EqualImage_Passes) {
  write_image("a.ppm", 10);
  write_image("references/a.ppm", 10);
  manifest("[[case]]\nimage = \"a.ppm\"\n");
  const Outcome outcome = run();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("1 case: 1 passed"));
  EXPECT_EQ(report()["cases"][0]["verdict"], "passed");
  EXPECT_EQ(report()["cases"][0]["identical"], true);
  EXPECT_NE(read_text(results() / "report.html").find("a/actual.ppm"), std::string::npos);
}

TEST_F(TestCommand, OtherImage_FailsAndSaysWhere) {
  write_image("a.ppm", 10);
  write_image("references/a.ppm", 10, 11);
  manifest("[[case]]\nimage = \"a.ppm\"\n");
  const Outcome outcome = run();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, AllOf(StartsWith("lume: failed: a: "), HasSubstr("pixel (1, 1)")));
  EXPECT_THAT(outcome.out, HasSubstr("1 case: 1 failed"));
  EXPECT_EQ(read_text(results() / "a/actual.ppm"), read_text(folder_ / "a.ppm"));
  EXPECT_EQ(read_text(results() / "a/expected.ppm"), read_text(folder_ / "references/a.ppm"));
  EXPECT_THAT(read_text(results() / "a/difference.png"), StartsWith("\x89PNG"));
  EXPECT_THAT(report()["cases"][0]["accept_command"].get<std::string>(),
              HasSubstr("lume test m.toml --filter a --update changed"));
}

TEST_F(TestCommand, Limits_DecideThePerceptualTier) {
  write_image("a.ppm", 10);
  write_image("references/a.ppm", 12);
  const std::string cases = "[[case]]\nimage = \"a.ppm\"\ntier = \"perceptual\"\nlimits = ";
  manifest(cases + "{ max = 0.01 }\n");
  EXPECT_EQ(run().exit_code, 0);
  manifest(cases + "{ max = 0.001 }\n");
  const Outcome outcome = run();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("(<= 0.001)"));
}

TEST_F(TestCommand, ImagesOfOtherSize_FailWithTheReason) {
  write_image("a.ppm", 10);
  write_image("references/a.ppm", 10);
  test::write_bytes(folder_ / "references/a.ppm", "P3 1 1 255\n10 10 10\n");
  manifest("[[case]]\nimage = \"a.ppm\"\n");
  const Outcome outcome = run();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("the image is 2x2, 1x1 is expected"));
}

TEST_F(TestCommand, Scenes_AreRenderedAsTheirOptionsSay) {
  write_scene("s/tri.gltf");
  write_scene("s/broken.gltf");
  test::write_bytes(folder_ / "s/broken.gltf", "{");
  manifest(
      "[defaults]\nrender = \"--width 24 --height 16 --spp 4\"\n"
      "[[case]]\nscene = \"s/*.gltf\"\n[[override]]\nname = \"tri\"\nrender = \"--seed 7\"\n");
  const Outcome first = run({"--update", "missing"});
  EXPECT_EQ(first.exit_code, 1);  // a scene that is broken does not keep others from being tested
  EXPECT_THAT(first.err, HasSubstr("failed: broken: s/broken.gltf"));
  EXPECT_EQ(run({"--filter", "tri"}).exit_code, 0);

  ASSERT_EQ(run_lume(folder_, {"render", "-q", "s/tri.gltf", "--width", "24", "--height", "16",
                               "--spp", "4", "--seed", "7", "-o", "by-hand.exr"})
                .exit_code,
            0);
  EXPECT_EQ(read_text(folder_ / "by-hand.exr"), read_text(folder_ / "references/tri.exr"));
}

TEST_F(TestCommand, StatisticalTier_TakesOtherNoiseButNoOtherLight) {
  write_scene("tri.gltf");
  const std::string cases =
      "[[case]]\nscene = \"tri.gltf\"\ntier = \"statistical\"\nseeds = 6\nsignificance = 1e-4\n"
      "render = \"--width 24 --height 16 --spp 2 --background ";
  manifest(cases + "1,1,1\"\n");
  EXPECT_EQ(run({"--update", "missing"}).exit_code, 0);
  manifest(cases + "1,1,1 --seed 100\"\n");
  EXPECT_EQ(run().exit_code, 0);
  EXPECT_THAT(report()["cases"][0]["message"].get<std::string>(), HasSubstr("bias"));
  EXPECT_EQ(report()["cases"][0]["identical"], false);
  manifest(cases + "1.1,1.1,1.1\"\n");
  EXPECT_EQ(run().exit_code, 1);
}

TEST_F(TestCommand, Commands_RunWithoutAShellInTheManifestsFolder) {
  write_image("a.ppm", 10);
  manifest(
      "[[case]]\nname = \"copy\"\ncommand = [\"cp\", \"a.ppm\", \"{output}\"]\n"
      "reference = \"$(touch x);.ppm\"\n"
      "[[case]]\nname = \"left\"\ncommand = [\"cp\", \"a.ppm\", \"b.ppm\"]\nimage = \"b.ppm\"\n"
      "[[case]]\nname = \"itself\"\ncommand = [\"{lume}\", \"--version\", \"{output}\"]\n");
  const Outcome outcome = run({"--update", "missing"});
  EXPECT_EQ(report()["cases"][0]["verdict"], "accepted");
  EXPECT_EQ(report()["cases"][1]["verdict"], "accepted");
  EXPECT_THAT(outcome.err, HasSubstr("itself: the command has not written"));
  EXPECT_EQ(read_text(folder_ / "references/left.ppm"), read_text(folder_ / "a.ppm"));
  EXPECT_EQ(read_text(folder_ / "references/$(touch x);.ppm"), read_text(folder_ / "a.ppm"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x"));
}

TEST_F(TestCommand, CommandsThatGoWrong_FailWithWhatTheySaid) {
  manifest(
      "[[case]]\nname = \"fails\"\ncommand = [\"sh\", \"-c\", \"echo one; echo two >&2; exit 3\", "
      "\"{output}\"]\n"
      "[[case]]\nname = \"dies\"\ncommand = [\"sh\", \"-c\", \"kill -SEGV $$\", \"{output}\"]\n"
      "[[case]]\nname = \"absent\"\ncommand = [\"./none\", \"{output}\"]\n");
  const Outcome outcome = run();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("fails: sh ended with exit code 3\n    | one\n    | two\n"));
  EXPECT_THAT(outcome.err, HasSubstr("dies: sh was ended by signal 11 (SEGV)"));
  EXPECT_THAT(outcome.err, HasSubstr("absent: ./none cannot be started"));
}

TEST_F(TestCommand, CommandThatHangs_IsEndedWithItsChildren) {
  manifest(
      "[[case]]\nname = \"hang\"\ntimeout = 1\ncommand = [\"sh\", \"-c\", "
      "\"(sleep 1.5; touch alive) & sleep 60\", \"{output}\"]\n");
  const Outcome outcome = run();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("took longer than 1 s"));
  EXPECT_LT(report()["seconds"].get<double>(), 2.5);
  usleep(1000000);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "alive"));
}

TEST_F(TestCommand, Interrupted_ReportsWhatWasDone) {
  write_image("a.ppm", 10);
  write_image("references/a.ppm", 10);
  manifest(
      "[[case]]\nimage = \"a.ppm\"\n[[case]]\nname = \"slow\"\ncommand = [\"sh\", \"-c\", "
      "\"touch begun; sleep 60\", \"{output}\"]\n[[case]]\nname = \"b\"\nimage = \"a.ppm\"\n");
  LumeProcess process(folder_.path(), {"test", "m.toml"});
  for (int i = 0; i < 6000 && !std::filesystem::exists(folder_ / "begun"); ++i) usleep(10000);
  process.send(SIGINT);
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("3 cases: 1 passed, 2 not run"));
  EXPECT_EQ(report()["interrupted"], true);
}

TEST_F(TestCommand, OnlySkips_AreExit77) {
  write_image("a.ppm", 10);
  write_image("references/a.ppm", 10);
  manifest(
      "[[case]]\nimage = \"a.ppm\"\n[[case]]\nname = \"b\"\nimage = \"a.ppm\"\nskip = \"no "
      "screen\"\n"
      "[[case]]\nscene = \"${LUME_NOT_SET}/*.gltf\"\nrequires_environment = \"LUME_NOT_SET\"\n");
  EXPECT_EQ(run().exit_code, 0);
  EXPECT_EQ(report()["cases"][1]["message"], "no screen");
  EXPECT_THAT(report()["cases"][2]["message"].get<std::string>(), HasSubstr("LUME_NOT_SET"));
  EXPECT_EQ(run({"--filter", "b"}).exit_code, 77);
}

TEST_F(TestCommand, BrokenManifest_IsAUsageErrorWithItsLine) {
  manifest("[[case]]\nscen = \"a\"\n");
  const Outcome outcome = run();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err,
              StartsWith("lume: error: m.toml:3: [[case]]: unknown key 'scen'; did you "
                         "mean scene?"));
  EXPECT_FALSE(std::filesystem::exists(results()));
}

}  // namespace
}  // namespace lume::cli
