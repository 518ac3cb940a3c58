// SPDX-License-Identifier: Apache-2.0
#include "renderer/render.h"

#include "geometry/parallel.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lume::renderer {
namespace {

using geometry::Vec3;
using shading::Scene;
using test::add_surface;

/// Spheres of many materials under an environment, an emitter and a point light.
Scene busy_scene() {
  test::Random random(1);
  Scene scene;
  for (int i = 0; i < 12; ++i) {
    auto& material =
        add_surface(scene, test::sphere_mesh(10), test::random_transform(random, 6.0f));
    material.base_color = {random.uniform(), random.uniform(), random.uniform()};
    material.metallic = std::round(random.uniform());
    material.roughness = random.uniform();
    material.transmission = i % 4 == 0 ? 1.0f : 0.0f;
    material.thickness = i % 8 == 0 ? 1.0f : 0.0f;
    if (i == 5) material.emission = shading::Color(4.0f);
    if (i == 7) material.alpha_mode = shading::AlphaMode::blend;
    if (i == 7) material.alpha = 0.4f;
  }
  scene.environment.emplace(shading::studio_environment());
  shading::PunctualLight light;
  light.position = {5, 20, 10};
  light.intensity = shading::Color(200.0f);
  scene.lights.push_back(light);
  return scene;
}

RenderSettings small_settings() {
  RenderSettings settings;
  settings.width = 61;
  settings.height = 43;
  settings.spp = 4;
  settings.aovs = {Aov::depth, Aov::normal, Aov::instance};
  return settings;
}

RenderResult render(const Scene& scene, const RenderSettings& settings,
                    std::string_view accelerator = "embree") {
  const PreparedScene prepared(scene, accelerator);
  const auto integrator = make_integrator("whitted", prepared, {});
  const auto camera = geometry::frame_bounds(scene.world.bounds(), 61.0f / 43.0f);
  return render_image(prepared, camera, *integrator, settings);
}

void expect_same(const Film& a, const Film& b) {
  ASSERT_EQ(a.region, b.region);
  EXPECT_TRUE(a.pixels == b.pixels);
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (std::size_t i = 0; i < a.layers.size(); ++i) {
    EXPECT_TRUE(a.layers[i].values == b.layers[i].values) << "layer " << i;
  }
}

TEST(RenderImage, AnyNumberOfThreads_GivesTheSamePixels) {
  const Scene scene = busy_scene();
  std::vector<RenderResult> results;
  for (const unsigned threads : {1u, 2u, 7u}) {
    const geometry::ThreadLimit limit(threads);
    results.push_back(render(scene, small_settings()));
  }
  expect_same(results[0].film, results[1].film);
  expect_same(results[0].film, results[2].film);
  EXPECT_EQ(results[0].rays.total(), results[2].rays.total());
  EXPECT_EQ(results[0].rays.camera, 61u * 43u * 4u);
  EXPECT_GT(results[0].rays.shadow, 0u);
  EXPECT_GT(results[0].rays.reflection, 0u);
  EXPECT_GT(results[0].rays.refraction, 0u);
  EXPECT_EQ(results[0].non_finite.count, 0u);
}

TEST(RenderImage, AnyAccelerator_GivesTheSamePixels) {
  const Scene scene = busy_scene();
  RenderSettings settings = small_settings();
  settings.spp = LUME_SANITIZED ? 1 : 4;
  expect_same(render(scene, settings).film, render(scene, settings, "brute-force").film);
}

TEST(RenderImage, Region_IsThatPartOfTheWhole) {
  const Scene scene = busy_scene();
  RenderSettings settings = small_settings();
  const Film whole = render(scene, settings).film;
  settings.region = {17, 9, 23, 20};
  const Film part = render(scene, settings).film;
  ASSERT_EQ(part.pixels.size(), 23u * 20u);
  for (std::size_t y = 0; y < 20; ++y) {
    for (std::size_t x = 0; x < 23; ++x) {
      ASSERT_EQ(part.pixels[y * 23 + x], whole.pixels[(y + 9) * 61 + x + 17]);
      ASSERT_EQ(part.layers[0].values[y * 23 + x], whole.layers[0].values[(y + 9) * 61 + x + 17]);
    }
  }
}

TEST(RenderImage, Seed_ChangesTheNoiseAndNotThePicture) {
  const Scene scene = busy_scene();
  RenderSettings settings = small_settings();
  settings.aovs.clear();
  settings.spp = 64;
  const Film one = render(scene, settings).film;
  settings.seed = 2;
  const Film two = render(scene, settings).film;
  EXPECT_FALSE(one.pixels == two.pixels);
  shading::Vec4 sum_one(0.0f);
  shading::Vec4 sum_two(0.0f);
  for (std::size_t i = 0; i < one.pixels.size(); ++i) {
    sum_one += one.pixels[i];
    sum_two += two.pixels[i];
  }
  EXPECT_LT(length(sum_one - sum_two), 0.02f * length(sum_one));
}

TEST(RenderImage, Cancelled_LeavesTheRestEmpty) {
  const Scene scene = busy_scene();
  const PreparedScene prepared(scene, "embree");
  const auto integrator = make_integrator("whitted", prepared, {});
  const auto camera = geometry::frame_bounds(scene.world.bounds(), 1.0f);
  RenderSettings settings = small_settings();
  settings.width = 256;
  settings.height = 256;
  settings.spp = 1;
  std::atomic<bool> cancel = false;
  double furthest = 0.0;
  RenderControl control;
  control.cancel = &cancel;
  control.on_progress = [&](double fraction) {
    EXPECT_GT(fraction, furthest);
    furthest = fraction;
    if (fraction > 0.2) cancel = true;
  };
  const RenderResult result = render_image(prepared, camera, *integrator, settings, control);
  EXPECT_TRUE(result.cancelled);
  EXPECT_LT(furthest, 0.5);
  EXPECT_LT(result.rays.camera, 256u * 256u / 2u);
}

TEST(RenderImage, OrthographicSquare_CoversItsShareOfPixels) {
  Scene scene;
  add_surface(scene, test::square_mesh(0.5f)).unlit = true;
  const PreparedScene prepared(scene, "embree");
  const auto integrator = make_integrator("whitted", prepared, {});
  geometry::Camera camera;
  camera.projection = geometry::Camera::Projection::orthographic;
  camera.position = {0, 0, 3};
  camera.half_height = 1.0f;
  RenderSettings settings;
  settings.width = 40;
  settings.height = 40;
  settings.spp = 64;
  settings.filter = PixelFilter(PixelFilter::Kind::box);
  settings.aovs = {Aov::depth,  Aov::position, Aov::normal,  Aov::geometric_normal,
                   Aov::albedo, Aov::instance, Aov::material};
  const RenderResult result = render_image(prepared, camera, *integrator, settings);
  double coverage = 0.0;
  for (const auto& pixel : result.film.pixels) coverage += static_cast<double>(pixel.w);
  EXPECT_NEAR(coverage, 400.0, 1e-3) << "a quarter of the image, edges on pixel borders";
  const auto channels = [&](std::size_t layer, std::size_t x, std::size_t y) {
    const std::size_t count = result.film.layers[layer].values.size() / 1600;
    return &result.film.layers[layer].values[(y * 40 + x) * count];
  };
  EXPECT_FLOAT_EQ(*channels(0, 20, 20), 3.0f);
  EXPECT_FLOAT_EQ(*channels(0, 1, 1), k_no_depth);
  EXPECT_NEAR(channels(1, 25, 12)[0], 5.5f / 20.0f, 1e-5f);  // x to the right
  EXPECT_NEAR(channels(1, 25, 12)[1], 7.5f / 20.0f, 1e-5f);  // y up
  EXPECT_FLOAT_EQ(channels(2, 20, 20)[2], 1.0f);
  EXPECT_FLOAT_EQ(channels(3, 20, 20)[2], 1.0f);
  EXPECT_FLOAT_EQ(channels(4, 20, 20)[1], 1.0f);
  EXPECT_EQ(*channels(5, 20, 20), 1.0f);
  EXPECT_EQ(*channels(6, 20, 20), 1.0f);
  EXPECT_EQ(*channels(6, 1, 1), 0.0f);
}

TEST(RenderImage, Position_IsInTheWorldAlsoFarFromItsOrigin) {
  Scene scene;
  add_surface(scene, test::square_mesh(0.5f)).unlit = true;
  scene.origin = {1e6, -2e6, 0.25};
  const PreparedScene prepared(scene, "embree");
  const auto integrator = make_integrator("whitted", prepared, {});
  geometry::Camera camera;
  camera.position = {0, 0, 3};
  RenderSettings settings;
  settings.width = 1;
  settings.height = 1;
  settings.spp = 1;
  settings.aovs = {Aov::position};
  const Film film = render_image(prepared, camera, *integrator, settings).film;
  const std::vector<float>& values = film.layers[0].values;
  EXPECT_FLOAT_EQ(values[0], 1e6f);
  EXPECT_FLOAT_EQ(values[1], -2e6f);
  EXPECT_FLOAT_EQ(values[2], 0.25f);
}

/// Brings back NaN for every seventh sample.
class Broken final : public Integrator {
 public:
  Radiance radiance(const geometry::Ray&, const Sampler&, Ledger&) const override {
    const bool broken = samples_++ % 7 == 3;
    Radiance result;
    result.terms.emitted = Color(broken ? std::numeric_limits<float>::quiet_NaN() : 1.0f);
    result.alpha = 1.0f;
    return result;
  }

 private:
  mutable int samples_ = 0;  // one tile, and so one thread
};

TEST(RenderImage, NonFiniteSamples_AreCountedLocatedAndLeftOut) {
  const Scene scene;
  const PreparedScene prepared(scene, "embree");
  RenderSettings settings;
  settings.width = 16;
  settings.height = 4;
  settings.spp = 2;
  const RenderResult result = render_image(prepared, {}, Broken{}, settings);
  EXPECT_EQ(result.non_finite.count, 18u);  // of 128 samples those 3, 10, 17 ... 122
  EXPECT_EQ(result.non_finite.x, 1);
  EXPECT_EQ(result.non_finite.y, 0);
  EXPECT_EQ(result.non_finite.sample, 1u);
  EXPECT_EQ(result.film.pixels[1], shading::Vec4(0.5f));
  EXPECT_EQ(result.film.pixels[0], shading::Vec4(1.0f));
}

}  // namespace
}  // namespace lume::renderer
