// SPDX-License-Identifier: Apache-2.0
// The tree of rays adds up to the pixel of the picture, to the last bit, in every scene of ours.
#include "tests/images/own_scenes.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>

namespace lume::tests {
namespace {

using renderer::LightNote;
using renderer::RayTree;
using renderer::SurfaceNote;
using shading::Color;

constexpr int k_width = 48;
constexpr int k_height = 36;
constexpr int k_pixels = 1000;

std::array<std::uint32_t, 3> bits(const Color& c) {
  return {std::bit_cast<std::uint32_t>(c.x), std::bit_cast<std::uint32_t>(c.y),
          std::bit_cast<std::uint32_t>(c.z)};
}

/// The formula again, term by term, from leaves and weights alone.
std::array<Color, 6> add_up(const RayTree& tree, std::size_t index) {
  std::array<Color, 6> sum{};
  sum.fill(Color(0.0f));
  const auto light_of = [&](const std::optional<renderer::TwigNote>& twig) {
    if (!twig) return Color(0.0f);
    const std::array<Color, 6> child = add_up(tree, twig->ray);
    Color light = child[0];
    for (std::size_t i = 1; i < child.size(); ++i) light += child[i];
    return twig->weight * light;
  };
  for (const SurfaceNote& surface : tree.rays[index].surfaces) {
    Color diffuse(0.0f);
    Color specular(0.0f);
    for (std::size_t i = 0; i < surface.light_count; ++i) {
      const LightNote& light = tree.lights[surface.first_light + i];
      diffuse += light.diffuse;
      specular += light.specular;
    }
    const std::array<Color, 6> terms = {
        surface.terms.emitted,        surface.terms.ambient,         diffuse, specular,
        light_of(surface.reflection), light_of(surface.transmission)};
    for (std::size_t i = 0; i < terms.size(); ++i) sum[i] += surface.scale * terms[i];
  }
  if (tree.rays[index].backdrop) sum[0] += *tree.rays[index].backdrop;
  return sum;
}

/// The mean of the samples, its terms added up last.
Color pixel_of(const std::vector<RayTree>& samples) {
  std::array<Color, 6> sum{};
  sum.fill(Color(0.0f));
  for (const RayTree& tree : samples) {
    const std::array<Color, 6> terms = add_up(tree, 0);
    for (std::size_t i = 0; i < terms.size(); ++i) sum[i] += terms[i];
  }
  const float scale = 1.0f / static_cast<float>(samples.size());
  Color color = scale * sum[0];
  for (std::size_t i = 1; i < sum.size(); ++i) color += scale * sum[i];
  return color;
}

class RayTrees : public testing::TestWithParam<std::string> {
 protected:
  RayTrees() : scene_(lit(load_own_scene(GetParam()))), prepared_(scene_, "embree") {}

  void expect_sums(std::string_view integrator_name, std::uint32_t spp) {
    SCOPED_TRACE(std::string(integrator_name) + ", spp " + std::to_string(spp));
    const auto integrator = renderer::make_integrator(integrator_name, prepared_, {});
    renderer::RenderSettings settings;
    settings.width = k_width;
    settings.height = k_height;
    settings.spp = spp;
    const geometry::Camera& camera = scene_.cameras.at(0);
    const auto film = renderer::render_image(prepared_, camera, *integrator, settings).film;
    test::Random random(spp);
    int lit = 0;
    for (int i = 0; i < k_pixels; ++i) {
      const auto x = static_cast<int>(random.below(k_width));
      const auto y = static_cast<int>(random.below(k_height));
      const auto trace = renderer::trace_pixel(camera, *integrator, settings, x, y);
      const shading::Vec4& pixel = film.pixels[static_cast<std::size_t>(y * k_width + x)];
      const Color rendered(pixel);
      const Color sum = pixel_of(trace.samples);
      const Color traced = trace.value.color();
      ASSERT_EQ(bits(sum), bits(rendered)) << x << "," << y;
      ASSERT_EQ(bits(traced), bits(rendered)) << x << "," << y;
      ASSERT_EQ(trace.value.alpha, pixel.w) << x << "," << y;
      lit += rendered != Color(0.0f);
    }
    EXPECT_GT(lit, k_pixels / 20) << "too dark to show anything";
  }

 private:
  shading::Scene scene_;
  renderer::PreparedScene prepared_;
};

TEST_P(RayTrees, ThousandPixels_AddUpToTheLastBit) {
  for (const std::string_view integrator : renderer::integrator_names()) {
    expect_sums(integrator, 1);
    expect_sums(integrator, 4);
  }
}

INSTANTIATE_TEST_SUITE_P(Assets, RayTrees, testing::ValuesIn(own_scene_names()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace lume::tests
