// SPDX-License-Identifier: Apache-2.0
// What must not change a picture: the number of threads, a crop, the accelerator, and (but for rays
// along edges) the instruction set that Embree chooses.
#include "geometry/parallel.h"
#include "tests/images/own_scenes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

namespace lume::tests {
namespace {

using renderer::Aov;
using renderer::Film;
using renderer::RenderResult;

template <typename T>
bool have_equal_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

void expect_equal_bits(const Film& a, const Film& b) {
  EXPECT_EQ(a.region, b.region);
  EXPECT_TRUE(have_equal_bits(a.pixels, b.pixels));
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (std::size_t i = 0; i < a.layers.size(); ++i) {
    EXPECT_TRUE(have_equal_bits(a.layers[i].values, b.layers[i].values)) << "layer " << i;
  }
}

/// The pixels of a part of a film.
std::vector<shading::Vec4> cut(const Film& film, const shading::PixelRegion& part) {
  std::vector<shading::Vec4> pixels;
  for (int y = part.y; y < part.y + part.height; ++y) {
    for (int x = part.x; x < part.x + part.width; ++x) {
      const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(film.region.width);
      pixels.push_back(film.pixels[row + static_cast<std::size_t>(x)]);
    }
  }
  return pixels;
}

const std::vector<Aov> k_all_aovs = {
    Aov::depth,       Aov::position, Aov::normal,          Aov::geometric_normal,
    Aov::albedo,      Aov::instance, Aov::material,        Aov::emitted,
    Aov::ambient,     Aov::diffuse,  Aov::specular,        Aov::reflected,
    Aov::transmitted, Aov::shadow,   Aov::recursion_depth, Aov::ray_count};

class Invariance : public testing::TestWithParam<std::string> {};

TEST_P(Invariance, ThreadCount_ChangesNoBit) {
  const Shot shot{.spp = 4, .aovs = k_all_aovs};
  const auto render = [&](unsigned threads) {
    const geometry::ThreadLimit limit(threads);
    return render_own_scene(GetParam(), shot);
  };
  const RenderResult one = render(1);
  for (const unsigned threads : {2u, 7u}) {
    SCOPED_TRACE(threads);
    const RenderResult many = render(threads);
    expect_equal_bits(one.film, many.film);
    EXPECT_EQ(one.rays.total(), many.rays.total());
  }
}

TEST_P(Invariance, Crop_IsAPartOfTheWhole) {
  constexpr shading::PixelRegion k_part{31, 17, 41, 29};  // not aligned to tiles
  const RenderResult whole = render_own_scene(GetParam(), {.spp = 4});
  const RenderResult part = render_own_scene(GetParam(), {.spp = 4, .region = k_part});
  EXPECT_EQ(part.film.region, k_part);
  EXPECT_TRUE(have_equal_bits(cut(whole.film, k_part), part.film.pixels));
}

/// Embree's kernels for different instruction sets round differently, so a ray that passes the edge
/// between two triangles within a float's rounding may be given to either. Such a pixel changes by
/// a last digit; no other pixel may change at all.
TEST_P(Invariance, InstructionSet_ChangesOnlyRaysAlongEdges) {
  const RenderResult best = render_own_scene(GetParam(), {.spp = 4});
  for (const char* limit : {"max_isa=sse2", "max_isa=avx2"}) {
    SCOPED_TRACE(limit);
    setenv("LUME_EMBREE_CONFIG", limit, 1);
    const RenderResult limited = render_own_scene(GetParam(), {.spp = 4});
    unsetenv("LUME_EMBREE_CONFIG");
    std::size_t changed = 0;
    for (std::size_t i = 0; i < best.film.pixels.size(); ++i) {
      const float difference = length(best.film.pixels[i] - limited.film.pixels[i]);
      if (difference == 0.0f) continue;
      ++changed;
      EXPECT_LT(difference, 1e-5f * length(best.film.pixels[i])) << "pixel " << i;
    }
    EXPECT_LE(changed, best.film.pixels.size() / 1000);
  }
}

INSTANTIATE_TEST_SUITE_P(Assets, Invariance,
                         testing::Values("afternoon", "alpha_modes", "desk_lamp", "far_away",
                                         "gems", "glass", "museum"),
                         [](const auto& scene) { return scene.param; });

class EqualAccelerators : public testing::TestWithParam<std::string> {};

TEST_P(EqualAccelerators, BruteForceAndEmbree_GiveEqualBits) {
  Shot shot{.width = 48, .height = 36, .spp = 4, .aovs = k_all_aovs};
  const RenderResult embree = render_own_scene(GetParam(), shot);
  shot.accelerator = "brute-force";
  const RenderResult brute_force = render_own_scene(GetParam(), shot);
  expect_equal_bits(embree.film, brute_force.film);
}

// Scenes of few triangles: brute force looks at each one for each ray. None has a ray that meets
// two triangles at exactly the same distance, where either answer would be right.
INSTANTIATE_TEST_SUITE_P(Assets, EqualAccelerators,
                         testing::Values("alpha_modes", "cornell", "desk_lamp", "gems",
                                         "normal_maps", "teapot", "textures", "whitted"),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace lume::tests
