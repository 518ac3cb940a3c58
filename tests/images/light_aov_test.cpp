// SPDX-License-Identifier: Apache-2.0
// The terms of light as layers, in every scene of ours.
#include "tests/images/own_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::tests {
namespace {

using renderer::Aov;
using renderer::Film;
using shading::Color;

constexpr int k_width = 48;
constexpr int k_height = 36;
constexpr std::uint32_t k_spp = 4;
constexpr std::size_t k_pixels = std::size_t{k_width} * k_height;

class LightAovs : public testing::TestWithParam<std::string> {
 protected:
  LightAovs() : scene_(lit(load_own_scene(GetParam()))), prepared_(scene_, "embree") {
    scene_.ambient = Color(0.25f);
  }

  [[nodiscard]] renderer::RenderResult render(const char* name, const std::vector<Aov>& aovs,
                                              const renderer::IntegratorSettings& method = {}) {
    const auto integrator = renderer::make_integrator(name, prepared_, method);
    renderer::RenderSettings settings;
    settings.width = k_width;
    settings.height = k_height;
    settings.spp = k_spp;
    settings.aovs = aovs;
    return renderer::render_image(prepared_, scene_.cameras.at(0), *integrator, settings);
  }

 private:
  shading::Scene scene_;
  renderer::PreparedScene prepared_;
};

Color color_at(const Film::Layer& layer, std::size_t pixel) {
  return {layer.values[3 * pixel], layer.values[3 * pixel + 1], layer.values[3 * pixel + 2]};
}

TEST_P(LightAovs, Terms_AddUpToThePictureToTheLastBit) {
  for (const char* integrator : {"whitted", "raycast"}) {
    const Film film = render(integrator, {Aov::emitted, Aov::ambient, Aov::diffuse, Aov::specular,
                                          Aov::reflected, Aov::transmitted})
                          .film;
    for (std::size_t i = 0; i < k_pixels; ++i) {
      Color sum = color_at(film.layers[0], i);
      for (std::size_t term = 1; term < film.layers.size(); ++term) {
        sum += color_at(film.layers[term], i);
      }
      ASSERT_EQ(sum, Color(film.pixels[i])) << integrator << ", pixel " << i;
    }
  }
}

TEST_P(LightAovs, Shadow_IsWhatIsMissingWithoutShadows) {
  const std::vector<Aov> aovs = {Aov::diffuse, Aov::specular, Aov::shadow};
  const Film film = render("raycast", aovs).film;
  const Film lit = render("raycast", aovs, {.shadows = false}).film;
  for (std::size_t i = 0; i < k_pixels; ++i) {
    const Color unshadowed = color_at(lit.layers[0], i) + color_at(lit.layers[1], i);
    const Color sum =
        color_at(film.layers[0], i) + color_at(film.layers[1], i) + color_at(film.layers[2], i);
    ASSERT_LE(length(sum - unshadowed), 1e-5f * (1.0f + length(unshadowed))) << "pixel " << i;
    ASSERT_EQ(color_at(lit.layers[2], i), Color(0.0f));
  }
}

TEST_P(LightAovs, RayCount_AddsUpToAllRays) {
  const auto result = render("whitted", {Aov::ray_count, Aov::recursion_depth});
  double rays = 0.0;
  for (std::size_t i = 0; i < k_pixels; ++i) {
    const auto count = static_cast<double>(result.film.layers[0].values[i]);
    const auto depth = static_cast<double>(result.film.layers[1].values[i]);
    ASSERT_GE(count, 1.0 + depth) << "each level is a ray";
    ASSERT_LE(depth, 5.0);
    rays += count * k_spp;
  }
  EXPECT_EQ(std::llround(rays), static_cast<long long>(result.rays.total()));
  const auto cast = render("raycast", {Aov::recursion_depth});
  for (const float depth : cast.film.layers[0].values) ASSERT_EQ(depth, 0.0f);
}

INSTANTIATE_TEST_SUITE_P(Assets, LightAovs, testing::ValuesIn(own_scene_names()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace lume::tests
