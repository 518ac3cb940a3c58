// SPDX-License-Identifier: Apache-2.0
// Every model of $LUME_TEST_DATA/gltf/assets that loads is rendered small. Which ones do not load
// yet, and why, is listed and tested in tests/io/gltf_conformance_test.cpp.
#include "io/error.h"
#include "io/gltf/load_gltf.h"
#include "tests/images/own_scenes.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

namespace lume::tests {
namespace {

namespace fs = std::filesystem;

/// Models in which nothing is to be seen from the front.
const std::set<std::string> k_empty_pictures = {};

std::optional<io::LoadedScene> load_supported(const fs::path& path) {
  try {
    return io::load_gltf(path);
  } catch (const io::Error& error) {
    EXPECT_EQ(error.kind(), io::ErrorKind::scene) << error.what();
    return std::nullopt;
  }
}

float mean_alpha(const renderer::Film& film) {
  float sum = 0.0f;
  for (const shading::Vec4& pixel : film.pixels) sum += pixel.w;
  return sum / static_cast<float>(film.pixels.size());
}

void expect_renders(const fs::path& path) {
  const auto loaded = load_supported(path);
  if (!loaded) return;
  const shading::Scene& scene = loaded->scene;
  const auto camera = geometry::frame_bounds(scene.world.bounds(), 1.0f);
  const auto result = render_scene(scene, camera, {.width = 64, .height = 64, .spp = 2});
  EXPECT_EQ(result.non_finite.count, 0u);
  for (const shading::Vec4& pixel : result.film.pixels) {
    ASSERT_GE(std::min({pixel.x, pixel.y, pixel.z}), 0.0f);
    ASSERT_LE(pixel.w, 1.0f);
  }
  const bool expected_empty =
      scene.world.instances.empty() || k_empty_pictures.contains(path.stem().string());
  EXPECT_EQ(mean_alpha(result.film) == 0.0f, expected_empty);
}

TEST(Conformance, SampleAssets_RenderToFinitePictures) {
  const auto data = test_data();
  if (!data) GTEST_SKIP() << "LUME_TEST_DATA is not set";
  const fs::path folder = *data / "gltf/assets";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
  int models = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path extension = entry.path().extension();
    if (extension != ".gltf" && extension != ".glb") continue;
    SCOPED_TRACE(entry.path().lexically_relative(folder));
    expect_renders(entry.path());
    ++models;
  }
  EXPECT_GT(models, 0);
}

}  // namespace
}  // namespace lume::tests
