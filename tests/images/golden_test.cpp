// SPDX-License-Identifier: Apache-2.0
// Each of our own scenes still looks as it did when its golden image was made. docs/scenes.md says
// how to make new ones.
#include "tests/images/exr_file.h"
#include "tests/images/own_scenes.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace lume::tests {
namespace {

using renderer::Aov;

std::filesystem::path golden_path(const std::string& scene) {
  return source_dir() / "tests" / "images" / "golden" / (scene + ".exr");
}

/// Scenes that show geometry rather than light are kept with what is known of their surfaces.
Shot golden_shot(const std::string& scene) {
  Shot shot;
  if (scene == "attributes" || scene == "far_away" || scene == "normal_maps") {
    shot.aovs = {Aov::depth, Aov::normal, Aov::albedo};
  }
  return shot;
}

bool wants_update() {
  return std::getenv("LUME_UPDATE_GOLDEN") != nullptr;  // NOLINT(concurrency-mt-unsafe): never set
}

/// How far the image is from the golden one. A value's difference is relative to the golden value,
/// but no smaller one than a hundredth is looked at with more than that precision.
struct Difference {
  double mean = 0.0;
  double outliers = 0.0;  ///< share of the values that differ by more than 1/500
  std::size_t non_finite = 0;
};

Difference compare(const ExrFile& image, const ExrFile& golden) {
  Difference result;
  for (std::size_t i = 0; i < golden.values.size(); ++i) {
    if (!std::isfinite(image.values[i])) {
      ++result.non_finite;
      continue;
    }
    const auto expected = static_cast<double>(golden.values[i]);
    const double difference = std::abs(static_cast<double>(image.values[i]) - expected) /
                              std::max(std::abs(expected), 0.01);
    result.mean += difference;
    result.outliers += difference > 1.0 / 500.0 ? 1.0 : 0.0;
  }
  const auto count = static_cast<double>(golden.values.size());
  result.mean /= count;
  result.outliers /= count;
  return result;
}

class GoldenImage : public testing::TestWithParam<std::string> {};

TEST_P(GoldenImage, OwnScene_LooksAsItDid) {
  const std::filesystem::path golden_file = golden_path(GetParam());
  const renderer::RenderResult result = render_own_scene(GetParam(), golden_shot(GetParam()));
  EXPECT_EQ(result.non_finite.count, 0u);

  if (wants_update()) {
    std::filesystem::create_directories(golden_file.parent_path());
    write_exr(golden_file, result.film);
    FAIL() << golden_file << " is written anew: look at it, then test without LUME_UPDATE_GOLDEN";
  }
  ASSERT_TRUE(std::filesystem::exists(golden_file))
      << golden_file << " is missing. To make it: LUME_UPDATE_GOLDEN=1 ctest --preset release -L "
      << "image";

  // Through a file, so that both sides are rounded to half floats in the same way.
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / ("lume_golden_" + GetParam() + ".exr");
  write_exr(file, result.film);
  const ExrFile image = read_exr(file);
  const ExrFile golden = read_exr(golden_file);
  ASSERT_EQ(image.width, golden.width);
  ASSERT_EQ(image.height, golden.height);
  ASSERT_EQ(image.channels, golden.channels);

  const Difference difference = compare(image, golden);
  EXPECT_EQ(difference.non_finite, 0u);
  // Files by g++ 12 and clang 14 are equal to the bit. What is left is for other versions of libm,
  // and for the variants that one libm chooses by processor: their last digit is far below a half
  // float's step, but now and then it sends a sample past the other side of an edge.
  EXPECT_LE(difference.mean, 1e-4) << file << " against " << golden_file;
  EXPECT_LE(difference.outliers, 0.002) << file << " against " << golden_file;
  if (!HasFailure()) std::filesystem::remove(file);
}

INSTANTIATE_TEST_SUITE_P(Assets, GoldenImage, testing::ValuesIn(own_scene_names()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace lume::tests
