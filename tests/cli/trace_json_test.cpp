// SPDX-License-Identifier: Apache-2.0
// What programs read of a ray tree is enough to add the pixel up again by the formula that
// docs/trace.md gives, in 32-bit floats, to the last bit.
#include "io/gltf/load_gltf.h"
#include "renderer/cli/trace_report.h"
#include "renderer/cli/trace_terms.h"
#include "renderer/render.h"
#include "tests/support/paths.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <bit>
#include <cmath>

namespace lume::cli {
namespace {

using nlohmann::json;
using shading::Color;

constexpr int k_width = 64;
constexpr int k_height = 48;

std::array<std::uint32_t, 3> bits(const Color& c) {
  return {std::bit_cast<std::uint32_t>(c.x), std::bit_cast<std::uint32_t>(c.y),
          std::bit_cast<std::uint32_t>(c.z)};
}

Color color_of(const json& value) {
  return {value.at(0).get<float>(), value.at(1).get<float>(), value.at(2).get<float>()};
}

constexpr std::array<const char*, 6> k_terms = {"emitted",  "ambient",   "diffuse",
                                                "specular", "reflected", "transmitted"};
using Terms = std::array<Color, 6>;

Color sum_of(const Terms& terms) {
  Color sum = terms[0];
  for (std::size_t i = 1; i < terms.size(); ++i) sum = sum + terms[i];
  return sum;
}

Terms terms_of_ray(const json& rays, std::size_t index) {
  Terms total;
  total.fill(Color(0.0f));
  const auto twig = [&](const json& surface, const char* key) {
    if (!surface.contains(key)) return Color(0.0f);
    return color_of(surface[key]["weight"]) * sum_of(terms_of_ray(rays, surface[key]["ray"]));
  };
  for (const json& surface : rays.at(index).at("surfaces")) {
    Terms terms = {color_of(surface["terms"]["emitted"]),
                   color_of(surface["terms"]["ambient"]),
                   Color(0.0f),
                   Color(0.0f),
                   twig(surface, "reflection"),
                   twig(surface, "transmission")};
    for (const json& light : surface.at("lights")) {
      terms[2] += color_of(light.at("diffuse"));
      terms[3] += color_of(light.at("specular"));
    }
    for (std::size_t i = 0; i < terms.size(); ++i) {
      total[i] += color_of(surface.at("scale")) * terms[i];
    }
  }
  if (rays[index].contains("backdrop")) total[0] += color_of(rays[index]["backdrop"]);
  return total;
}

Terms pixel_of(const json& samples) {
  Terms total;
  total.fill(Color(0.0f));
  for (const json& sample : samples) {
    const Terms terms = terms_of_ray(sample.at("rays"), 0);
    for (std::size_t i = 0; i < terms.size(); ++i) total[i] += terms[i];
  }
  const float scale = 1.0f / static_cast<float>(samples.size());
  for (Color& term : total) term = scale * term;
  return total;
}

class TraceJson : public testing::Test {
 protected:
  TraceJson()
      : scene_(io::load_gltf(tests::source_dir() / "assets/scenes/whitted.gltf").scene),
        prepared_(scene_, "embree") {
    settings_.width = k_width;
    settings_.height = k_height;
    options_.scene_file = "whitted.gltf";
  }

  TraceReport trace(const renderer::Integrator& integrator, int x, int y) {
    options_.spp = settings_.spp;
    options_.pixel = PixelPlace{x, y};
    return {options_, scene_, {k_width, k_height},
            "",       "",     trace_pixel(scene_.cameras.at(0), integrator, settings_, x, y)};
  }

  /// One of the random pixels of the whole picture at a time.
  void expect_sums(std::string_view name, std::uint32_t spp, int count) {
    settings_.spp = spp;
    const auto integrator = renderer::make_integrator(name, prepared_, {});
    const renderer::Film film =
        render_image(prepared_, scene_.cameras.at(0), *integrator, settings_).film;
    test::Random random(7 + spp);
    for (int i = 0; i < count; ++i) {
      const auto x = static_cast<int>(random.below(k_width));
      const auto y = static_cast<int>(random.below(k_height));
      const TraceReport report = trace(*integrator, x, y);
      ASSERT_TRUE(adds_up(report.trace));
      const json tree = json::parse(trace_to_json(report));
      const Terms terms = pixel_of(tree.at("samples"));
      const Color sum = sum_of(terms);
      const Color pixel(film.pixels[static_cast<std::size_t>(y * k_width + x)]);
      ASSERT_EQ(bits(sum), bits(pixel)) << name << " " << x << "," << y;
      ASSERT_EQ(color_of(tree["value"]["color"]), pixel);
      for (std::size_t k = 0; k < terms.size(); ++k) {
        ASSERT_EQ(color_of(tree["value"].at(k_terms[k])), terms[k]) << k_terms[k];
      }
    }
  }

  shading::Scene scene_;
  renderer::PreparedScene prepared_;
  renderer::RenderSettings settings_;
  TraceOptions options_;
};

TEST_F(TraceJson, ThousandPixels_AddUpToTheLastBit) {
  expect_sums("whitted", 1, 1000);
  expect_sums("raycast", 1, 1000);
}

TEST_F(TraceJson, SeveralSamples_AddUpToTheLastBit) {
  expect_sums("whitted", 4, 250);
  expect_sums("raycast", 4, 250);
}

TEST_F(TraceJson, Rays_NameTheirParents) {
  settings_.spp = 1;
  const auto integrator = renderer::make_integrator("whitted", prepared_, {});
  std::size_t children = 0;
  for (int x = 0; x < k_width; ++x) {
    const json tree = json::parse(trace_to_json(trace(*integrator, x, k_height / 2)));
    const json& rays = tree["samples"][0]["rays"];
    EXPECT_FALSE(rays[0].contains("parent"));
    for (std::size_t i = 1; i < rays.size(); ++i, ++children) {
      const json& parent = rays.at(rays[i].at("parent").get<std::size_t>());
      EXPECT_EQ(rays[i]["depth"], parent["depth"].get<int>() + 1);
      const json& surface = parent.at("surfaces").at(0);
      const char* twig = rays[i]["kind"] == "reflection" ? "reflection" : "transmission";
      EXPECT_EQ(surface.at(twig).at("ray"), i);
      const Color start = color_of(rays[i]["origin"]);
      EXPECT_LT(length(start - color_of(surface["position"])), 1e-3f);
    }
  }
  EXPECT_GT(children, 50u);
}

TEST_F(TraceJson, InfiniteNumbers_AreLeftOut) {
  const auto integrator = renderer::make_integrator("whitted", prepared_, {});
  TraceReport report = trace(*integrator, 30, 24);
  ASSERT_FALSE(report.trace.samples[0].rays[0].surfaces.empty());
  report.trace.samples[0].rays[0].surfaces[0].terms.emitted = Color(NAN);
  const std::string text = trace_to_json(report);
  EXPECT_EQ(text.find("null"), std::string::npos);
  const json ray = json::parse(text)["samples"][0]["rays"][0];
  EXPECT_FALSE(ray.contains("t_max"));
  EXPECT_FALSE(ray["surfaces"][0]["terms"].contains("emitted"));
  EXPECT_FALSE(adds_up(report.trace));
}

TEST_F(TraceJson, AnyChangedTerm_IsNoticed) {
  const auto integrator = renderer::make_integrator("whitted", prepared_, {});
  renderer::PixelTrace trace = this->trace(*integrator, 20, 40).trace;
  ASSERT_TRUE(adds_up(trace));
  ASSERT_FALSE(trace.samples[0].lights.empty());
  Color& light = trace.samples[0].lights[0].diffuse;
  light.x = std::nextafter(light.x, 1e9f);
  EXPECT_FALSE(adds_up(trace));
}

}  // namespace
}  // namespace lume::cli
