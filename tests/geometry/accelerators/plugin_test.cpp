// SPDX-License-Identifier: Apache-2.0
// Plugins: the one that docs/adding_an_accelerator.md shows, and one that lies.
#include "geometry/accelerators/accelerator.h"
#include "geometry/accelerators/two_level.h"
#include "tests/geometry/accelerators/example_structure.h"
#include "tests/support/agreement.h"
#include "tests/support/cases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace lume::geometry {
namespace {

using test::Random;
using ::testing::HasSubstr;

TEST(Plugin, MedianBvh_MeetsWhatBruteForceMeets) {
  Random random(1);
  int hits = 0;
  int others = 0;
  for (int round = 0; round < 5; ++round) {
    const World world = test::mixed_world(random);
    const auto plugin = make_accelerator(LUME_MEDIAN_BVH, world, nullptr);
    const auto oracle = make_accelerator("brute-force", world, nullptr);
    for (int i = 0; i < test::cases(4000); ++i) {
      const Ray ray = test::random_ray(random);
      const auto expected = oracle->closest_hit(ray);
      const auto found = plugin->closest_hit(ray);
      hits += expected ? 1 : 0;
      // It decides in float whether an edge is met, and of a ray that is rounded to float.
      others += found != expected || plugin->any_hit(ray) != expected.has_value() ? 1 : 0;
    }
  }
  EXPECT_GT(hits, test::cases(5000));
  EXPECT_LE(others, 5);
}

TEST(Plugin, Holes_AreLookedThrough) {
  class LeftHalf final : public HoleTest {
   public:
    [[nodiscard]] bool is_hole(const Hit&, Vec2 uv) const override { return uv.x < 0.5f; }
  };
  World world;
  test::add_instance(world, test::square_mesh());
  world.objects[0].geometries[0].has_holes = true;
  const LeftHalf holes;
  const auto plugin = make_accelerator(LUME_MEDIAN_BVH, world, &holes);
  EXPECT_FALSE(plugin->closest_hit({.origin = {-0.4f, 0.3f, 1.0f}}));
  EXPECT_FALSE(plugin->any_hit({.origin = {-0.4f, 0.3f, 1.0f}}));
  EXPECT_TRUE(plugin->any_hit({.origin = {0.3f, -0.4f, 1.0f}}));
}

/// What make_accelerator, or else a ray through a lone square or past it, complains of.
std::string complaint(const std::string& file, const char* lie, const Vec3& origin = {0, 0, 1}) {
  setenv("LUME_LIAR", lie, 1);
  World world;
  test::add_instance(world, test::square_mesh());
  std::string message = "nothing";
  try {
    const auto plugin = make_accelerator(file, world, nullptr);
    (void)plugin->closest_hit({.origin = origin});
  } catch (const std::runtime_error& error) {
    message = error.what();
  }
  unsetenv("LUME_LIAR");
  return message;
}

TEST(Plugin, Lies_AreNamedWithTheFile) {
  const std::string liar = LUME_LIAR_PLUGIN;
  EXPECT_EQ(complaint(liar, "number"), liar + ": names triangle 1000000 of 2");
  EXPECT_THAT(complaint(liar, "nan"), HasSubstr("which is not on the ray"));
  EXPECT_THAT(complaint(liar, "refuse"), HasSubstr("refuses to build over 2 triangles: too tired"));
  EXPECT_THAT(complaint(liar, "version"), HasSubstr("version 99 of the plugin interface"));
  EXPECT_THAT(complaint(liar, "nothing"), HasSubstr("returns nothing"));
  // A triangle that is not where the ray is: the box around both is met, beside the first.
  EXPECT_THAT(complaint(liar, "wrong", {-0.4f, 0.45f, 1}), HasSubstr("which the ray passes by"));
}

TEST(Plugin, CrashWhileBuilding_IsSurvived) {
  const std::string liar = LUME_LIAR_PLUGIN;
  EXPECT_THAT(complaint(liar, "crash"), HasSubstr("crashed (signal 6)"));
}

TEST(Plugin, HangWhileBuilding_EndsAfterFiveSeconds) {
  EXPECT_THAT(complaint(LUME_LIAR_PLUGIN, "hang"), HasSubstr("did not build"));
}

TEST(Plugin, WhatIsNoPlugin_IsNamed) {
  EXPECT_THAT(complaint("./none.so", ""), HasSubstr("./none.so: cannot be loaded"));
  EXPECT_THAT(complaint("/lib/x86_64-linux-gnu/libm.so.6", ""),
              HasSubstr("is no accelerator plugin"));
}

std::string text_of(const std::string& name) {
  std::ifstream file(LUME_SOURCE_DIR "/" + name);
  EXPECT_TRUE(file) << name;
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Plugin, ExampleInTheDocs_IsTheOneThatIsTested) {
  EXPECT_THAT(text_of("docs/adding_an_accelerator.md"),
              HasSubstr("```cpp\n" + text_of("tests/plugins/median_bvh.cpp") + "```\n"));
}

TEST(ExampleStructure, BoxList_NamesWhatBruteForceNames) {
  Random random(2);
  const World world = test::mixed_world(random);
  const TwoLevel<BoxList> boxes(world, nullptr);
  const auto oracle = make_accelerator("brute-force", world, nullptr);
  for (int i = 0; i < test::cases(5000); ++i) {
    const Ray ray = test::random_ray(random);
    ASSERT_EQ(boxes.closest_hit(ray), oracle->closest_hit(ray));
    ASSERT_EQ(boxes.any_hit(ray), oracle->any_hit(ray));
  }
  EXPECT_THAT(text_of("docs/adding_an_accelerator.md"),
              HasSubstr(text_of("tests/geometry/accelerators/example_structure.h")));
}

}  // namespace
}  // namespace lume::geometry
