// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/render_options.h"

#include "renderer/cli/exit_codes.h"
#include "renderer/cli/output_name.h"
#include "renderer/cli/replay.h"

#include <gtest/gtest.h>
#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace lume::cli {
namespace {

RenderOptions parse(std::vector<std::string> arguments) {
  CLI::App app;
  RenderOptions options;
  add_render_options(app, options);
  app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  return options;
}

void parse_and_check(const std::vector<std::string>& arguments) {
  check_render_options(parse(arguments));
}

TEST(RenderOptions, Defaults_AreThoseOfTheHelp) {
  const RenderOptions options = parse({"a.glb", "-o", "a.png"});
  EXPECT_EQ(options.scene_file, "a.glb");
  EXPECT_EQ(options.spp, 16u);
  EXPECT_EQ(options.filter, "blackman-harris");
  EXPECT_EQ(options.integrator, "whitted");
  EXPECT_EQ(options.accelerator, "wide");
  EXPECT_FALSE(options.width || options.height || options.crop || options.camera);
}

TEST(RenderOptions, OutputRepeats_OthersCountAsGivenLast) {
  const RenderOptions options =
      parse({"-o", "a.png", "--spp", "4", "-o", "b.exr", "scene.glb", "--spp=8", "--output=c.jpg"});
  EXPECT_EQ(options.outputs, (std::vector<std::string>{"a.png", "b.exr", "c.jpg"}));
  EXPECT_EQ(options.scene_file, "scene.glb");
  EXPECT_EQ(options.spp, 8u);
}

TEST(RenderOptions, NegativeValues_AreNotTakenForOptions) {
  const RenderOptions options =
      parse({"a.glb", "--exposure", "-1.5", "--orbit", "-90,45,2", "--target", "-1,-2,-3"});
  EXPECT_EQ(options.exposure, -1.5f);
  EXPECT_EQ(options.orbit, geometry::DVec3(-90.0, 45.0, 2.0));
  EXPECT_EQ(options.target, geometry::DVec3(-1.0, -2.0, -3.0));
}

TEST(RenderOptions, LargestSeed_IsKept) {
  EXPECT_EQ(parse({"--seed", "18446744073709551615"}).seed, ~std::uint64_t{0});
}

TEST(RenderOptions, ValuesOutOfRange_AreRefused) {
  const std::vector<std::vector<std::string>> bad = {
      {"--spp", "0"},        {"--spp", "1048577"},      {"--width", "0"},
      {"--height", "65536"}, {"--max-depth", "101"},    {"--threads", "1025"},
      {"--fov", "180"},      {"--exposure", "nan"},     {"--filter-radius", "0"},
      {"--quality", "101"},  {"--compression", "zap"},  {"--filter", "bx"},
      {"--accelerator", ""}, {"--integrator", "patth"}, {"-o", "--spp"}};
  for (const auto& arguments : bad) {
    EXPECT_THROW((void)parse(arguments), CLI::ParseError) << arguments[0] << ' ' << arguments[1];
  }
  EXPECT_THROW((void)parse({"--aperture", "-1"}), CLI::ParseError);
  EXPECT_THROW((void)parse({"--cutoff", "1.5"}), CLI::ParseError);
  EXPECT_THROW((void)parse({"--occlusion", "-1"}), CLI::ParseError);
  EXPECT_THROW((void)parse({"--background", "1,-1,1"}), UsageError);
  EXPECT_THROW((void)parse({"--ambient", "1,-1,1"}), UsageError);
  EXPECT_THROW((void)parse({"--crop", "1x1"}), UsageError);
}

TEST(RenderOptions, OptionsOfAnEnvironmentWithoutOne_AreRefused) {
  EXPECT_THROW((void)parse({"--env-hidden"}), CLI::ParseError);
  EXPECT_THROW((void)parse({"--env-rotate", "1"}), CLI::ParseError);
  EXPECT_THROW((void)parse({"--env", "a.hdr", "--background", "1,1,1"}), CLI::ParseError);
}

TEST(RenderOptions, Contradictions_AreRefused) {
  const std::vector<std::vector<std::string>> bad = {
      {},
      {"a.glb"},
      {"-o", "a.png"},
      {"a.glb", "-o", "a.png", "--orbit", "0,90,1", "--camera", "0"},
      {"a.glb", "-o", "a.png", "--orbit", "0,90,0"},
      {"a.glb", "-o", "a.png", "--target", "0,0,0"},
      {"a.glb", "-o", "a.png", "--focus", "2"},
      {"a.glb", "-o", "a.png", "--focus", "0", "--aperture", "0.1"},
      {"a.glb", "-o", "a.png", "--aov", "depth"},
      {"a.glb", "-o", "a.png", "-o", "./a.png"},
      {"a.glb", "-o", "f.#.png", "-o", "f.1.png"},
      {"a.glb", "-o", "a.exr", "--env", "a.exr"},
      {"a.glb", "-o", "a.exr", "--stats", "a.glb"},
  };
  for (const auto& arguments : bad) {
    EXPECT_THROW(parse_and_check(arguments), UsageError) << testing::PrintToString(arguments);
  }
  EXPECT_NO_THROW(parse_and_check({"a.glb", "-o", "a.png", "-o", "a.exr", "--aov", "all"}));
}

TEST(OutputName, LastRunOfHashes_BecomesTheNumber) {
  EXPECT_EQ(frame_path("a.####.exr", 7), "a.0007.exr");
  EXPECT_EQ(frame_path("##/a#b##.png", 123), "##/a#b123.png");
  EXPECT_EQ(frame_path("#.png", 1), "1.png");
  EXPECT_EQ(frame_path("x/a.png", 1), "x/a.png");
}

TEST(Replay, Command_KeepsWhatMakesThePixelAndDropsTheRest) {
  EXPECT_EQ(replay_command({"my scene.glb", "-o", "a.png", "--spp", "4", "--stats=s.json", "--crop",
                            "9x9+0+0", "-ob.exr", "--output=c.exr", "--seed", "3"},
                           5, 6),
            "lume render 'my scene.glb' --spp 4 --seed 3 --crop 1x1+5+6 -o replay.exr");
}

}  // namespace
}  // namespace lume::cli
