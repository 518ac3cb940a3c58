// SPDX-License-Identifier: Apache-2.0
// `lume render` from the outside.
#include "tests/cli/run_lume.h"
#include "tests/support/gltf_file.h"
#include "tests/support/paths.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <string>
#include <vector>

namespace lume::cli {
namespace {

using testing::HasSubstr;

/// A triangle before a camera, which fills about half of the picture.
class RenderCommand : public testing::Test {
 protected:
  RenderCommand() {
    test::GltfFile file = test::triangle_file();
    file.json["nodes"][1]["translation"] = {0.5, 0.5, 2.0};
    file.write(folder_ / "a.gltf");
  }

  Outcome render(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"render", "a.gltf"});
    return run_lume(folder_, std::move(arguments));
  }

  struct Pixels {
    OIIO::ImageSpec spec;
    std::vector<float> values;
  };
  Pixels read(const std::string& name) {
    const auto input = OIIO::ImageInput::open((folder_ / name).string());
    if (!input) return {};
    Pixels pixels{input->spec(), {}};
    pixels.values.resize(pixels.spec.image_pixels() *
                         static_cast<std::size_t>(pixels.spec.nchannels));
    EXPECT_TRUE(input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, pixels.values.data()));
    return pixels;
  }

  tests::TemporaryFolder folder_;
};

TEST_F(RenderCommand, Raycast_WritesItsTerms) {
  const Outcome outcome =
      render({"-o", "a.exr", "--width", "32", "--integrator", "raycast", "--ambient", "0.25,0.5,1",
              "--no-shadows", "--float", "--aov", "ambient,recursion_depth"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Pixels pixels = read("a.exr");
  EXPECT_EQ(pixels.spec.get_string_attribute("lume:integrator"), "raycast");
  const auto& names = pixels.spec.channelnames;
  EXPECT_THAT(names,
              testing::IsSupersetOf({"ambient.R", "ambient.G", "ambient.B", "recursion_depth.V"}));
}

TEST_F(RenderCommand, ApertureWithoutAnythingInTheMiddle_AsksForTheFocus) {
  const std::vector<std::string> away = {"-o",     "a.png",    "--width", "8",          "--orbit",
                                         "0,90,3", "--target", "50,0,0",  "--aperture", "0.1"};
  const Outcome outcome = render(away);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--focus"));
  auto focused = away;
  focused.insert(focused.end(), {"--focus", "2"});
  EXPECT_EQ(render(focused).exit_code, 0);
}

TEST_F(RenderCommand, TwoOutputs_AreBothWritten) {
  const Outcome outcome = render({"-o", "a.png", "-o", "a.exr", "--width", "32"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(read("a.png").spec.width, 32);
  EXPECT_EQ(read("a.png").spec.height, 18);
  EXPECT_EQ(read("a.exr").spec.get_string_attribute("lume:integrator"), "whitted");
}

TEST_F(RenderCommand, Quiet_SaysNothing) {
  const Outcome outcome = render({"-o", "a.exr", "--width", "8", "--spp", "1", "-q"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
}

TEST_F(RenderCommand, Stats_HoldEveryKey) {
  const Outcome outcome = render({"-o", "a.exr", "--width", "32", "--height", "16", "--spp", "3",
                                  "--threads", "2", "--stats", "stats.json", "--seed", "9"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto stats = nlohmann::json::parse(read_text(folder_ / "stats.json"));
  for (const char* key : {"load_seconds", "build_seconds", "render_seconds", "write_seconds",
                          "rays_per_second", "peak_memory_bytes"}) {
    EXPECT_GE(stats.at(key).get<double>(), 0.0) << key;
  }
  EXPECT_EQ(stats["rays"]["camera"], 32 * 16 * 3);
  for (const char* kind : {"shadow", "reflection", "refraction"}) {
    EXPECT_TRUE(stats["rays"][kind].is_number_unsigned()) << kind;
  }
  EXPECT_EQ(stats["threads"], 2);
  EXPECT_EQ(stats["width"], 32);
  EXPECT_EQ(stats["height"], 16);
  EXPECT_EQ(stats["spp"], 3);
  EXPECT_EQ(stats["seed"], 9);
  EXPECT_EQ(stats["interrupted"], false);
}

TEST_F(RenderCommand, Threads_DoNotChangeTheFile) {
  ASSERT_EQ(render({"-o", "1.exr", "--width", "48", "--threads", "1"}).exit_code, 0);
  ASSERT_EQ(render({"-o", "7.exr", "--width", "48", "--threads", "7"}).exit_code, 0);
  EXPECT_EQ(read_text(folder_ / "1.exr"), read_text(folder_ / "7.exr"));
}

TEST_F(RenderCommand, Crop_HasTheSamePixelsAsTheWhole) {
  const std::vector<std::string> whole = {"-o", "whole.exr", "--width", "40", "--height", "30"};
  ASSERT_EQ(render(whole).exit_code, 0);
  ASSERT_EQ(render({"-o", "part.exr", "--width", "40", "--height", "30", "--crop", "10x8+15+11"})
                .exit_code,
            0);
  const Pixels all = read("whole.exr");
  const Pixels part = read("part.exr");
  EXPECT_EQ(part.spec.full_width, 40);
  EXPECT_EQ(part.spec.full_height, 30);
  ASSERT_EQ(part.spec.width, 10);
  ASSERT_EQ(part.spec.height, 8);
  ASSERT_EQ(part.spec.x, 15);
  ASSERT_EQ(part.spec.y, 11);
  const auto channels = static_cast<std::size_t>(part.spec.nchannels);
  bool any_light = false;
  for (std::size_t y = 0; y < 8; ++y) {
    for (std::size_t i = 0; i < 10 * channels; ++i) {
      const float expected = all.values[((y + 11) * 40 + 15) * channels + i];
      EXPECT_EQ(part.values[y * 10 * channels + i], expected);
      any_light = any_light || expected > 0.0f;
    }
  }
  EXPECT_TRUE(any_light);
}

TEST_F(RenderCommand, CropOutside_IsAUsageError) {
  const Outcome outcome = render({"-o", "a.exr", "--width", "40", "--crop", "10x8+31+0"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("outside"));
}

TEST_F(RenderCommand, Aovs_BecomeChannels) {
  ASSERT_EQ(render({"-o", "a.exr", "--width", "16", "--aov", "all"}).exit_code, 0);
  const auto names = read("a.exr").spec.channelnames;
  for (const char* name : {"R", "A", "Z", "P.x", "N.z", "Ng.y"}) {
    EXPECT_THAT(names, testing::Contains(name));
  }
}

TEST_F(RenderCommand, FrameMarks_BecomeOne) {
  ASSERT_EQ(render({"-o", "a.####.exr", "--width", "8"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "a.0001.exr"));
}

TEST_F(RenderCommand, UnknownCamera_IsAUsageError) {
  const Outcome outcome = render({"-o", "a.exr", "--camera", "5"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("unknown camera '5'"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.exr"));
}

TEST_F(RenderCommand, FileBroken_LeavesNothingBehind) {
  test::write_bytes(folder_ / "a.gltf", "{");
  EXPECT_EQ(render({"-o", "a.exr", "--stats", "a.json"}).exit_code, 3);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.exr"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.json"));
}

TEST_F(RenderCommand, InvisibleTriangle_StillGivesABackdrop) {
  const Outcome outcome = render({"-o", "a.exr", "--width", "8", "--orbit", "0,90,5", "--target",
                                  "100,0,0", "--background", "0.25,0.5,1"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Pixels pixels = read("a.exr");
  EXPECT_EQ(pixels.values[0], 0.25f);
  EXPECT_EQ(pixels.values[1], 0.5f);
  EXPECT_EQ(pixels.values[2], 1.0f);
}

TEST_F(RenderCommand, Interrupted_WritesWhatIsDone) {
  for (const int signal : {SIGINT, SIGTERM}) {
    // Half a minute of work, in tiles that take milliseconds.
    LumeProcess process(folder_.path(),
                        {"render", "a.gltf", "-o", "a.exr", "--width", "1024", "--height", "1024",
                         "--spp", "32", "--background", "1,1,1", "--stats", "a.json"});
    ASSERT_TRUE(process.wait_for("10%"));
    process.send(signal);
    const Outcome outcome = process.wait();
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(read_text(folder_ / "a.json"))["interrupted"], true);

    const Pixels pixels = read("a.exr");
    ASSERT_EQ(pixels.values.size(), 1024u * 1024u * 4u);
    EXPECT_EQ(pixels.spec.get_string_attribute("lume:incomplete"), "interrupted");
    // With a backdrop everywhere, alpha is 1 in what is done and 0 in what was not begun.
    std::size_t done = 0;
    for (std::size_t i = 3; i < pixels.values.size(); i += 4) done += pixels.values[i] > 0.0f;
    EXPECT_GT(done, 1024u * 1024u / 20u);
    EXPECT_LT(done, 1024u * 1024u);
    std::filesystem::remove(folder_ / "a.exr");
  }
}

TEST_F(RenderCommand, SecondInterrupt_EndsAtOnce) {
  // The first one waits for the pixels that have begun: seconds, with so many samples of this
  // scene.
  const auto scene = tests::source_dir() / "assets/scenes/afternoon.gltf";
  LumeProcess process(folder_.path(), {"render", scene.string(), "-o", "a.exr", "--width", "256",
                                       "--spp", "1048576"});
  ASSERT_TRUE(process.wait_for("samples each"));
  process.send(SIGINT);
  ASSERT_TRUE(process.wait_for("once more"));
  process.send(SIGINT);
  EXPECT_EQ(process.wait().exit_code, 130);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.exr"));
}

}  // namespace
}  // namespace lume::cli
