// SPDX-License-Identifier: Apache-2.0
#include "io/color.h"

#include "io/error.h"
#include "tests/io/file_bytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <thread>

namespace lume::io {
namespace {

using shading::Color;
using ::testing::HasSubstr;
using ::testing::Not;
using tests::TemporaryFolder;
using tests::write_bytes;

/// Sets or (nullptr) unsets $OCIO for one test.
class OcioVariable {
 public:
  explicit OcioVariable(const char* value) {
    if (const char* old = std::getenv("OCIO")) old_ = old;
    value != nullptr ? ::setenv("OCIO", value, 1) : ::unsetenv("OCIO");
  }
  OcioVariable(const OcioVariable&) = delete;
  OcioVariable& operator=(const OcioVariable&) = delete;
  ~OcioVariable() { old_ ? ::setenv("OCIO", old_->c_str(), 1) : ::unsetenv("OCIO"); }

 private:
  std::optional<std::string> old_;
};

double srgb_formula(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

Color through(const ViewTransform& view, Color color) {
  view.apply(std::span(&color, 1));
  return color;
}

ViewTransform own_view(const std::string& display, const std::string& view) {
  const OcioVariable unset(nullptr);
  return ViewTransform(ViewRequest{{}, display, view});
}

std::string message_of(const ViewRequest& request) {
  try {
    const ViewTransform view(request);
    return "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input_output);
    EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
    return error.what();
  }
}

constexpr const char* k_foreign_config = R"(ocio_profile_version: 2
roles: {default: raw, scene_linear: working, data: raw}
file_rules: [!<Rule> {name: Default, colorspace: default}]
displays:
  Monitor:
    - !<View> {name: Doubled, colorspace: doubled}
    - !<View> {name: Plain, colorspace: working}
colorspaces:
  - !<ColorSpace> {name: working}
  - !<ColorSpace> {name: doubled, from_scene_reference: !<MatrixTransform> {matrix: [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1]}}
  - !<ColorSpace> {name: raw, isdata: true}
)";

void expect_near(const Color& actual, const Color& expected, float tolerance) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], tolerance) << "channel " << c;
}

TEST(PbrNeutral, PublishedValues_AreMet) {
  expect_near(tone_map_pbr_neutral(Color(0.0f)), Color(0.0f), 0.0f);
  expect_near(tone_map_pbr_neutral(Color(0.04f)), Color(0.01f), 1e-6f);
  expect_near(tone_map_pbr_neutral(Color(0.5f)), Color(0.46f), 1e-6f);
  expect_near(tone_map_pbr_neutral(Color(0.8f)), Color(0.76f), 1e-6f);
  expect_near(tone_map_pbr_neutral(Color(1.0f)), Color(0.869091f), 1e-6f);
  expect_near(tone_map_pbr_neutral({2.0f, 1.0f, 0.5f}), {0.96f, 0.534091f, 0.321136f}, 1e-6f);
  expect_near(tone_map_pbr_neutral({10.0f, 0.0f, 0.0f}), {0.993924f, 0.571142f, 0.571142f}, 1e-6f);
}

TEST(PbrNeutral, GreyRamp_IsMonotonicAndStaysBelowOne) {
  float last = 0.0f;
  for (int i = 1; i <= 10000; ++i) {
    const float value = tone_map_pbr_neutral(Color(static_cast<float>(i) * 0.002f)).y;
    ASSERT_GT(value, last);
    ASSERT_LT(value, 1.0f);
    last = value;
  }
}

TEST(ViewTransform, Default_IsPbrNeutralOnSrgbWhateverOcioSays) {
  const OcioVariable broken("/nonexistent/config.ocio");
  const ViewTransform view;
  EXPECT_EQ(view.display(), "sRGB");
  EXPECT_EQ(view.view(), "PBR Neutral");
  EXPECT_EQ(view.config_name(), "lume");
  const auto expected = static_cast<float>(srgb_formula(0.869091));
  expect_near(through(view, Color(1.0f)), Color(expected), 2e-5f);
}

TEST(ViewTransform, EmptyRequest_IsTheDefault) {
  const ViewTransform view = own_view("", "");
  EXPECT_EQ(view.display(), "sRGB");
  EXPECT_EQ(view.view(), "PBR Neutral");
}

TEST(ViewTransform, StandardOnSrgb_IsTheFormula) {
  const ViewTransform view = own_view("sRGB", "Standard");
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0.0f, 1.2f);
  std::vector<Color> colors(10000);
  for (Color& color : colors) color = {uniform(random), uniform(random), 0.01f * uniform(random)};
  std::vector<Color> encoded = colors;
  view.apply(encoded);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      ASSERT_NEAR(encoded[i][c], std::min(1.0, srgb_formula(colors[i][c])), 2e-5);
    }
  }
}

TEST(ViewTransform, StandardOnRec709_IsBt1886) {
  const ViewTransform view = own_view("Rec.709", "Standard");
  for (const float x : {0.001f, 0.02f, 0.18f, 0.5f, 1.0f}) {
    expect_near(through(view, Color(x)), Color(std::pow(x, 1.0f / 2.4f)), 3e-5f);
  }
}

TEST(ViewTransform, StandardOnDisplayP3_ConvertsPrimaries) {
  const ViewTransform view = own_view("Display P3", "Standard");
  const auto grey = static_cast<float>(srgb_formula(0.18));
  expect_near(through(view, Color(0.18f)), Color(grey), 3e-5f);
  // Pure sRGB red in Display P3 is the well-known (234, 51, 35).
  const Color red = through(view, {1.0f, 0.0f, 0.0f}) * 255.0f;
  expect_near(red, {234.0f, 51.0f, 35.0f}, 0.6f);
}

TEST(ViewTransform, AcesSdr_MapsBlackToBlackAndIsMonotonicOnGreys) {
  for (const char* display : {"sRGB", "Rec.709", "Display P3"}) {
    const ViewTransform view = own_view(display, "ACES SDR");
    EXPECT_LT(through(view, Color(0.0f)).x, 0.01f);
    float last = -1.0f;
    for (int step = 0; step < 160; ++step) {
      const Color value = through(view, Color(0.05f * static_cast<float>(step)));
      EXPECT_GE(value.y, last) << display;
      EXPECT_NEAR(value.x, value.y, 0.02f) << "grey stays grey";
      last = value.y;
    }
    EXPECT_GT(last, 0.9f);
  }
}

TEST(ViewTransform, Raw_ReturnsNumbersAsTheyAre) {
  const ViewTransform view = own_view("sRGB", "Raw");
  for (const Color& color : {Color(0.0f, 0.25f, 1.0f), Color(0.1f, 0.5f, 0.123456f)}) {
    EXPECT_EQ(through(view, color), color);
  }
}

TEST(ViewTransform, ValuesThatAreNotFinite_CountAsZeroAndSpareTheirNeighbours) {
  constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float k_infinity = std::numeric_limits<float>::infinity();
  for (const char* name : {"PBR Neutral", "Standard", "ACES SDR", "Raw"}) {
    const ViewTransform view = own_view("sRGB", name);
    EXPECT_EQ(through(view, {k_nan, 0.5f, k_infinity}), through(view, {0.0f, 0.5f, 0.0f})) << name;
    for (const Color& wild : {Color(1e30f, 1e6f, 0.5f), Color(-5.0f, -1e30f, 2.0f)}) {
      const Color value = through(view, wild);
      for (int c = 0; c < 3; ++c) {
        EXPECT_GE(value[c], 0.0f) << name;
        EXPECT_LE(value[c], 1.0f) << name;
      }
    }
    EXPECT_GT(through(view, Color(1e30f)).y, 0.95f) << name;
  }
}

TEST(ViewTransform, ManyPixels_EqualSinglePixels) {
  const ViewTransform view;
  std::mt19937 random(8);
  std::uniform_real_distribution<float> uniform(0.0f, 4.0f);
  std::vector<Color> colors(10001);  // several chunks and a rest
  for (Color& color : colors) color = {uniform(random), uniform(random), uniform(random)};
  std::vector<Color> together = colors;
  view.apply(together);
  for (std::size_t i = 0; i < colors.size(); i += 37) {
    ASSERT_EQ(together[i], through(view, colors[i])) << i;
  }
  view.apply({});
}

TEST(ViewTransform, CopiesOnSeveralThreads_GiveTheSameColors) {
  const ViewTransform view = own_view("sRGB", "ACES SDR");
  const std::vector<Color> colors(20000, Color(0.3f, 0.6f, 0.1f));
  std::vector<std::vector<Color>> results(4, colors);
  std::vector<std::thread> threads;
  threads.reserve(results.size());
  for (std::vector<Color>& result : results) {
    threads.emplace_back([copy = view, &result] { copy.apply(result); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<Color>& result : results) EXPECT_EQ(result, results.front());
  EXPECT_NE(results.front(), colors);
}

TEST(ViewTransform, NamesWithOtherCaseAndDashes_AreUnderstood) {
  EXPECT_EQ(own_view("srgb", "pbr-neutral").view(), "PBR Neutral");
  EXPECT_EQ(own_view("DISPLAY-P3", "aces-sdr").display(), "Display P3");
  EXPECT_EQ(own_view("rec.709", "STANDARD").view(), "Standard");
}

TEST(ViewTransform, UnknownNames_SuggestTheNearestAndListAll) {
  const OcioVariable unset(nullptr);
  const std::string view = message_of({{}, "sRGB", "Standrad"});
  EXPECT_THAT(view, HasSubstr("did you mean Standard?"));
  EXPECT_THAT(view, HasSubstr("PBR Neutral, Standard, ACES SDR, Raw"));
  const std::string display = message_of({{}, "p3", ""});
  EXPECT_THAT(display, HasSubstr("did you mean Display P3?"));
  EXPECT_THAT(display, HasSubstr("sRGB, Rec.709, Display P3"));
}

TEST(ViewTransform, BrokenOcioVariable_IsNamedInTheError) {
  const OcioVariable broken("/nonexistent/config.ocio");
  const std::string message = message_of({});
  EXPECT_THAT(message, HasSubstr("$OCIO"));
  EXPECT_THAT(message, HasSubstr("/nonexistent/config.ocio"));
  EXPECT_THROW(static_cast<void>(available_views()), Error);
}

TEST(ViewTransform, FileThatIsNoConfiguration_IsAnError) {
  const TemporaryFolder folder;
  write_bytes(folder / "bad.ocio", "roles: [1, 2\n}} nonsense");
  EXPECT_THAT(message_of({folder / "bad.ocio", "", ""}), HasSubstr("bad.ocio"));
  write_bytes(folder / "empty.ocio", "");
  EXPECT_THAT(message_of({folder / "empty.ocio", "", ""}), HasSubstr("empty.ocio"));
  EXPECT_NE(message_of({folder / ".", "", ""}), "no error");
}

TEST(ViewTransform, ForeignConfiguration_UsesItsDefaultViewAndSceneLinear) {
  const TemporaryFolder folder;
  write_bytes(folder / "studio.ocio", k_foreign_config);
  const std::string path = (folder / "studio.ocio").string();
  const OcioVariable variable(path.c_str());
  const ViewTransform view{ViewRequest{}};
  EXPECT_EQ(view.display(), "Monitor");
  EXPECT_EQ(view.view(), "Doubled");
  EXPECT_EQ(view.config_name(), path);
  expect_near(through(view, {0.1f, 0.2f, 0.75f}), {0.2f, 0.4f, 1.0f}, 1e-6f);
  EXPECT_THAT(message_of({{}, "", "PBR Neutral"}), HasSubstr("there are: Doubled, Plain"));
}

TEST(AvailableViews, OwnConfiguration_OffersPbrNeutralFirstOnEachDisplay) {
  const OcioVariable unset(nullptr);
  const std::vector<DisplayViews> all = available_views();
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].display, "sRGB");
  const std::vector<std::string> expected{"PBR Neutral", "Standard", "ACES SDR", "Raw"};
  for (const DisplayViews& display : all) {
    EXPECT_EQ(display.views, expected);
    for (const std::string& view : display.views) {
      EXPECT_EQ(own_view(display.display, view).view(), view);
    }
  }
}

}  // namespace
}  // namespace lume::io
