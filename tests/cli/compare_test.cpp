// SPDX-License-Identifier: Apache-2.0
// `lume compare` as a user runs it.
#include "tests/cli/run_lume.h"
#include "tests/support/random.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <string>
#include <vector>

namespace lume::cli {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// A noisy grey image; `level` is its mean.
struct Shot {
  int width = 24;
  int height = 16;
  int x = 0;
  std::vector<std::string> channels = {"R", "G", "B"};
  unsigned seed = 1;
  float level = 0.5f;
  float noise = 0.05f;
};

class CompareCommand : public testing::Test {
 protected:
  void write(const std::string& name, const Shot& shot, float first = -1.0f) const {
    OIIO::ImageSpec spec(shot.width, shot.height, static_cast<int>(shot.channels.size()),
                         OIIO::TypeDesc::FLOAT);
    spec.channelnames = shot.channels;
    spec.x = shot.x;
    spec.full_width = 24;
    if (shot.x == 0) spec.full_width = shot.width;
    test::Random random(shot.seed);
    std::vector<float> values(spec.image_pixels() * shot.channels.size());
    for (float& value : values) value = shot.level * (1.0f + random.uniform(-1, 1) * shot.noise);
    if (first >= 0.0f || first != first) values[0] = first;
    const std::string path = (folder_.path() / name).string();
    const auto output = OIIO::ImageOutput::create(path);
    ASSERT_TRUE(output && output->open(path, spec));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close());
  }

  [[nodiscard]] Outcome compare(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "compare");
    return run_lume(folder_, std::move(arguments));
  }

  tests::TemporaryFolder folder_;
};

TEST_F(CompareCommand, EqualPixels_PassWhateverTheFormat) {
  write("a.exr", {});
  write("a.tif", {});
  const Outcome outcome = compare({"a.tif", "a.exr"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("passed: the pixels are equal\n"));
}

TEST_F(CompareCommand, Difference_IsSaidWithItsPlace) {
  write("a.exr", {}, 0.75f);
  write("b.exr", {}, 0.5f);
  const Outcome outcome = compare({"a.exr", "b.exr"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("failed: the pixels are not equal"),
                                 HasSubstr("0.25, is in R of pixel (0, 0)"), HasSubstr("rmse")));
  EXPECT_EQ(compare({"a.exr", "b.exr", "--max", "0.3"}).exit_code, 0);
  EXPECT_EQ(compare({"a.exr", "b.exr", "--max", "0.3", "--flip-max", "0"}).exit_code, 1);
}

TEST_F(CompareCommand, WhatCannotBeCompared_HasExitCodesOfItsOwn) {
  write("expected.exr", {});
  write("size.exr", {.height = 15});
  write("nan.exr", {}, std::numeric_limits<float>::quiet_NaN());
  write("channels.exr", {.channels = {"R", "G", "B", "A"}});
  write("window.exr", {.width = 20, .x = 2});
  const std::pair<const char*, int> codes[] = {
      {"size.exr", 5}, {"nan.exr", 6}, {"channels.exr", 8}, {"window.exr", 9}, {"absent.exr", 4}};
  for (const auto& [name, code] : codes) {
    // However generous the limits are.
    const Outcome outcome = compare({name, "expected.exr", "--max", "1e9"});
    EXPECT_EQ(outcome.exit_code, code) << name << outcome.out << outcome.err;
    EXPECT_EQ(outcome.out.starts_with("refused: "), code != 4) << name;
  }
}

TEST_F(CompareCommand, Ignore_LeavesChannelsOut) {
  write("a.exr", {.channels = {"R", "G", "B", "id.X"}, .seed = 1});
  write("b.exr", {.channels = {"R", "G", "B"}, .seed = 1});
  EXPECT_EQ(compare({"a.exr", "b.exr", "--max", "1"}).exit_code, 8);
  EXPECT_EQ(compare({"a.exr", "b.exr", "--max", "1", "--ignore", "id.*"}).exit_code, 0);
  EXPECT_EQ(compare({"a.exr", "b.exr", "--ignore", "*"}).exit_code, 2);
}

TEST_F(CompareCommand, Json_HasWhatTheTextHas) {
  write("a.exr", {.seed = 1});
  write("b.exr", {.seed = 2});
  const Outcome outcome = compare({"a.exr", "b.exr", "--rmse", "1e-6", "--json", "-"});
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report.at("verdict"), "failed");
  EXPECT_EQ(report.at("exit_code"), outcome.exit_code);
  EXPECT_FALSE(report.at("identical"));
  EXPECT_EQ(report.at("flip").at("kind"), "HDR");
  bool found = false;
  for (const json& metric : report.at("metrics")) {
    if (metric.at("name") != "rmse") continue;
    found = true;
    EXPECT_TRUE(metric.at("failed"));
    EXPECT_EQ(metric.at("limit"), 1e-6);
    EXPECT_NEAR(metric.at("value").get<double>(), 0.5 * 0.05 * std::sqrt(2.0 / 3.0), 1e-3);
  }
  EXPECT_TRUE(found);
}

TEST_F(CompareCommand, Pictures_ShowWhereTheyDiffer) {
  write("a.exr", {}, 0.9f);
  write("b.exr", {});
  const Outcome outcome =
      compare({"a.exr", "b.exr", "--diff", "d.png", "--html", "d.html", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out + outcome.err, "");
  const auto input = OIIO::ImageInput::open((folder_.path() / "d.png").string());
  ASSERT_TRUE(input);
  EXPECT_EQ(input->spec().width, 48);
  EXPECT_EQ(input->spec().height, 16);
  std::vector<float> red(std::size_t{48} * 16);
  ASSERT_TRUE(input->read_image(0, 0, 0, 1, OIIO::TypeDesc::FLOAT, red.data()));
  EXPECT_GT(red[0], 0.99f);  // it differs here
  EXPECT_EQ(red[5], 0.0f);   // and nothing does there
  EXPECT_THAT(read_text(folder_.path() / "d.html"), AllOf(HasSubstr("a.exr"), HasSubstr("b.exr")));

  ASSERT_EQ(compare({"a.exr", "b.exr", "--diff", "d.exr"}).exit_code, 1);
  const auto exr = OIIO::ImageInput::open((folder_.path() / "d.exr").string());
  ASSERT_TRUE(exr);
  EXPECT_GE(exr->spec().channelindex("flip.Y"), 0);
}

TEST_F(CompareCommand, Seeds_TellNoiseFromBias) {
  std::vector<std::string> actual;
  std::vector<std::string> biased;
  std::vector<std::string> expected;
  for (unsigned i = 0; i < 8; ++i) {
    const std::string number = std::to_string(i) + ".exr";
    write("a" + number, {.seed = 100 + i, .noise = 0.2f});
    write("b" + number, {.seed = 200 + i, .level = 0.51f, .noise = 0.2f});
    write("e" + number, {.seed = 300 + i, .noise = 0.2f});
    if (i == 0) continue;
    actual.push_back("a" + number);
    biased.push_back("b" + number);
    expected.push_back("e" + number);
  }
  const auto with_seeds = [&](const std::string& first, const std::vector<std::string>& seeds) {
    std::vector<std::string> arguments = {first, "e0.exr", "--actual-seeds"};
    arguments.insert(arguments.end(), seeds.begin(), seeds.end());
    arguments.emplace_back("--expected-seeds");
    arguments.insert(arguments.end(), expected.begin(), expected.end());
    return compare(arguments);
  };
  const Outcome same = with_seeds("a0.exr", actual);
  EXPECT_EQ(same.exit_code, 0) << same.out << same.err;
  EXPECT_THAT(same.out, HasSubstr("would have seen a bias of"));
  const Outcome other = with_seeds("b0.exr", biased);
  EXPECT_EQ(other.exit_code, 1) << other.out << other.err;
}

TEST_F(CompareCommand, Mistakes_AreOneLine) {
  write("a.exr", {});
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {"a.exr"},
      {"a.exr", "a.exr", "--rsme", "1"},
      {"a.exr", "a.exr", "--flip", "-1"},
      {"a.exr", "a.exr", "--flip", "x"},
      {"a.exr", "a.exr", "--html", "a.exr"},
      {"a.exr", "a.exr", "--statistical", "--max", "1"}};
  for (const auto& arguments : wrong) {
    const Outcome outcome = compare(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  EXPECT_THAT(compare(wrong[2]).err, HasSubstr("did you mean '--rmse'"));
}

}  // namespace
}  // namespace lume::cli
