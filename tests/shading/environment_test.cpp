// SPDX-License-Identifier: Apache-2.0
#include "shading/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lume::shading {
namespace {

using geometry::k_pi;

Vec3 direction_at(double azimuth, double y) {
  const double radius = std::sqrt(std::max(0.0, 1.0 - y * y));
  return {static_cast<float>(radius * std::cos(azimuth)), static_cast<float>(y),
          static_cast<float>(radius * std::sin(azimuth))};
}

/// Mostly dim with a few very bright texels and one black row, as measured skies are.
std::vector<Color> random_sky(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  std::vector<Color> pixels(static_cast<std::size_t>(width * height));
  for (Color& pixel : pixels) {
    const float boost = uniform(random) < 0.03f ? 200.0f : 1.0f;
    pixel = Color(uniform(random), uniform(random), uniform(random)) * boost;
  }
  for (int y = height / 2 - 1; y <= height / 2 + 1; ++y) {
    for (int x = 0; x < width; ++x) pixels[static_cast<std::size_t>(y * width + x)] = Color(0.0f);
  }
  return pixels;
}

/// Integral over the sphere by the midpoint rule in (azimuth, y), where areas are equal.
template <typename Function>
auto integrate(int rows, int columns, const Function& f) {
  decltype(f(Vec3(0.0f)) * 1.0) sum(0.0);
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      sum += f(direction_at(2.0 * k_pi * (i + 0.5) / columns, 1.0 - 2.0 * (j + 0.5) / rows)) * 1.0;
    }
  }
  return sum * (4.0 * k_pi / (static_cast<double>(rows) * columns));
}

TEST(Environment, Mapping_FollowsTheHeader) {
  // Four columns: u = 1/8 is between -x and -z, 3/8 between -z and +x, and so on around.
  std::vector<Color> pixels(8);
  for (int i = 0; i < 8; ++i) pixels[static_cast<std::size_t>(i)] = Color(static_cast<float>(i));
  const Environment environment(4, 2, pixels);
  const float h = std::sqrt(0.5f);  // latitude 45 degrees: v = 1/4, the centres of the upper row
  const auto at = [&](float x, float y, float z) {
    return environment.radiance(geometry::normalize(Vec3(x, y, z))).x;
  };
  EXPECT_NEAR(at(-0.5f, h, -0.5f), 0.0f, 1e-4f);
  EXPECT_NEAR(at(0.5f, h, -0.5f), 1.0f, 1e-4f);
  EXPECT_NEAR(at(0.5f, h, 0.5f), 2.0f, 1e-4f);
  EXPECT_NEAR(at(-0.5f, h, 0.5f), 3.0f, 1e-4f);
  EXPECT_NEAR(at(-0.5f, -h, -0.5f), 4.0f, 1e-4f);
  EXPECT_NEAR(at(h, h, 0.0f), 1.5f, 1e-4f) << "+x is the middle of the map";
  EXPECT_NEAR(at(-h, h, 0.0f), 1.5f, 1e-4f) << "-x is the seam: columns 3 and 0 are neighbours";
}

TEST(Environment, Seam_IsContinuous) {
  const Environment environment(16, 8, random_sky(16, 8, 4));
  for (int i = 0; i < 100; ++i) {
    const double y = -0.99 + 0.0198 * i;
    const Color before = environment.radiance(direction_at(k_pi - 1e-5, y));
    const Color after = environment.radiance(direction_at(-k_pi + 1e-5, y));
    EXPECT_NEAR(before.x, after.x, 1e-3f * (1.0f + before.x));
  }
}

TEST(Environment, RotatedByAQuarter_TakesLightFromPlusXToMinusZ) {
  std::vector<Color> pixels(64 * 32, Color(0.0f));
  for (int y = 14; y < 18; ++y) {
    for (int x = 30; x < 34; ++x) pixels[static_cast<std::size_t>(y * 64 + x)] = Color(5.0f);
  }
  Environment environment(64, 32, pixels);
  EXPECT_NEAR(environment.radiance({1.0f, 0.0f, 0.0f}).x, 5.0f, 1e-4f);
  environment.rotate(0.25f * k_pi);
  environment.rotate(0.25f * k_pi);
  EXPECT_NEAR(environment.radiance({0.0f, 0.0f, -1.0f}).x, 5.0f, 1e-4f);
  EXPECT_EQ(environment.radiance({1.0f, 0.0f, 0.0f}).x, 0.0f);
  EXPECT_EQ(environment.radiance({0.0f, 0.0f, 1.0f}).x, 0.0f);

  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  for (int i = 0; i < 1000; ++i) {
    const DirectionSample sample = environment.sample({uniform(random), uniform(random)});
    EXPECT_LT(sample.direction.z, -0.9f);
  }
}

TEST(Environment, Scale_MultipliesRadianceAndNotDensity) {
  Environment environment(8, 4, random_sky(8, 4, 2));
  const Vec3 direction = geometry::normalize(Vec3(0.3f, 0.8f, -0.2f));
  const Color radiance = environment.radiance(direction);
  const float pdf = environment.pdf(direction);
  environment.scale(2.0f);
  environment.scale(3.0f);
  EXPECT_NEAR(environment.radiance(direction).y, 6.0f * radiance.y, 1e-4f * radiance.y);
  EXPECT_EQ(environment.pdf(direction), pdf);
}

TEST(Environment, Constant_IsUniformOverTheSphere) {
  Environment environment(Color(0.5f, 1.0f, 2.0f));
  environment.rotate(1.0f);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  Vec3 mean(0.0f);
  Vec3 mean_square(0.0f);
  constexpr int k_samples = 20000;
  for (int i = 0; i < k_samples; ++i) {
    const DirectionSample sample = environment.sample({uniform(random), uniform(random)});
    ASSERT_NEAR(length(sample.direction), 1.0f, 1e-5f);
    ASSERT_FLOAT_EQ(sample.pdf, 1.0f / (4.0f * k_pi));
    ASSERT_FLOAT_EQ(environment.pdf(sample.direction), sample.pdf);
    mean += sample.direction / static_cast<float>(k_samples);
    mean_square += sample.direction * sample.direction / static_cast<float>(k_samples);
  }
  // The deviation of the mean is sqrt(1/3 / n), of the mean square sqrt(4/45 / n).
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(mean[c], 0.0f, 4.5f * std::sqrt(1.0f / 3.0f / k_samples));
    EXPECT_NEAR(mean_square[c], 1.0f / 3.0f, 4.5f * std::sqrt(4.0f / 45.0f / k_samples));
  }
  EXPECT_EQ(environment.radiance({0.0f, 1.0f, 0.0f}), Color(0.5f, 1.0f, 2.0f));
}

TEST(Environment, Pdf_IntegratesToOne) {
  const Environment environment(16, 8, random_sky(16, 8, 9));
  const double integral =
      integrate(2000, 1600, [&](const Vec3& d) { return double{environment.pdf(d)}; });
  EXPECT_NEAR(integral, 1.0, 2e-3);
}

TEST(Environment, Pdf_IsPositiveWhereThereIsLight) {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  // One bright texel at a time: its light reaches into the neighbours, across the seam as well.
  for (std::size_t texel = 0; texel < 16 * 8; ++texel) {
    std::vector<Color> pixels(16 * 8, Color(0.0f));
    pixels[texel] = Color(1.0f);
    const Environment environment(16, 8, pixels);
    for (int i = 0; i < 1000; ++i) {
      const Vec3 direction = direction_at(k_pi * uniform(random), uniform(random));
      if (luminance(environment.radiance(direction)) > 1e-4f) {
        ASSERT_GT(environment.pdf(direction), 0.0f) << texel;
      }
    }
  }
}

TEST(Environment, SampleDensity_EqualsPdf) {
  Environment environment(32, 16, random_sky(32, 16, 12));
  environment.rotate(0.7f);
  std::mt19937 random(13);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  int different = 0;
  constexpr int k_samples = 50000;
  for (int i = 0; i < k_samples; ++i) {
    const DirectionSample sample = environment.sample({uniform(random), uniform(random)});
    ASSERT_NEAR(length(sample.direction), 1.0f, 1e-5f);
    ASSERT_GT(sample.pdf, 0.0f);
    const float pdf = environment.pdf(sample.direction);
    different += std::abs(pdf - sample.pdf) > 1e-4f * sample.pdf ? 1 : 0;
  }
  // Only where rounding carries a direction over the edge of a texel.
  EXPECT_LT(different, k_samples / 1000);
}

TEST(Environment, SampledDirections_PassChiSquared) {
  constexpr int k_rows = 24;
  constexpr int k_columns = 36;
  constexpr int k_samples = 400000;
  Environment environment(16, 8, random_sky(16, 8, 14));
  environment.rotate(-1.1f);
  std::vector<double> expected(k_rows * k_columns);
  constexpr int k_sub = 24;
  for (int j = 0; j < k_rows * k_sub; ++j) {
    for (int i = 0; i < k_columns * k_sub; ++i) {
      const Vec3 d = direction_at(2.0 * k_pi * (i + 0.5) / (k_columns * k_sub) - k_pi,
                                  1.0 - 2.0 * (j + 0.5) / (k_rows * k_sub));
      expected[static_cast<std::size_t>(j / k_sub * k_columns + i / k_sub)] +=
          environment.pdf(d) * 4.0 * k_pi / (k_rows * k_columns * k_sub * k_sub) * k_samples;
    }
  }
  std::mt19937 random(19);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  std::vector<int> counts(expected.size());
  for (int i = 0; i < k_samples; ++i) {
    const Vec3 d = environment.sample({uniform(random), uniform(random)}).direction;
    const int row = std::min(static_cast<int>((1.0f - d.y) * 0.5f * k_rows), k_rows - 1);
    const double turn = (std::atan2(d.z, d.x) + k_pi) / (2.0 * k_pi);
    const int column = std::min(static_cast<int>(turn * k_columns), k_columns - 1);
    ++counts[static_cast<std::size_t>(row * k_columns + column)];
  }
  double chi_squared = 0.0;
  int cells = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (expected[i] < 20.0) continue;  // few: the quadrature of a cell is not exact
    chi_squared += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
    ++cells;
  }
  ASSERT_GT(cells, 400);
  const double spread = 2.0 / (9.0 * cells);
  const double z = (std::cbrt(chi_squared / cells) - (1.0 - spread)) / std::sqrt(spread);
  EXPECT_LT(z, 5.0);
  EXPECT_GT(z, -5.0);
}

TEST(Environment, MonteCarloIntegral_EqualsQuadrature) {
  const Environment environment(24, 12, random_sky(24, 12, 21));
  // A cosine-weighted integral, so that directions matter and not only their number.
  const auto integrand = [&](const Vec3& d) {
    return glm::dvec3(environment.radiance(d) * std::max(d.y, 0.1f));
  };
  const glm::dvec3 expected = integrate(1500, 1500, integrand);
  const glm::dvec3 square =
      integrate(500, 500, [&](const Vec3& d) { return integrand(d) * integrand(d); });
  std::mt19937 random(22);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  constexpr int k_samples = 300000;
  glm::dvec3 sum(0.0);
  glm::dvec3 sum_of_squares(0.0);
  for (int i = 0; i < k_samples; ++i) {
    const DirectionSample sample = environment.sample({uniform(random), uniform(random)});
    const glm::dvec3 value = integrand(sample.direction) / static_cast<double>(sample.pdf);
    sum += value;
    sum_of_squares += value * value;
  }
  const glm::dvec3 mean = sum / static_cast<double>(k_samples);
  const glm::dvec3 variance = sum_of_squares / static_cast<double>(k_samples) - mean * mean;
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(mean[c], expected[c],
                4.5 * std::sqrt(variance[c] / k_samples) + 1e-3 * expected[c]);
    // Sampling that follows the radiance beats uniform directions by far.
    EXPECT_LT(variance[c], 0.2 * (4.0 * k_pi * square[c] - expected[c] * expected[c]));
  }
}

TEST(Environment, PolesAndBadDirections_GiveFiniteValues) {
  const Environment environment(16, 8, random_sky(16, 8, 25));
  for (const Vec3& d : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 1.0000001f, 0), Vec3(-1, 0, 0),
                        Vec3(-1, 0, -0.0f), Vec3(-1, 0, -1e-30f)}) {
    EXPECT_TRUE(geometry::is_finite(environment.radiance(d)));
    EXPECT_TRUE(std::isfinite(environment.pdf(d)));
  }
  for (const float u : {0.0f, 0x1.fffffep-1f}) {
    for (const float v : {0.0f, 0x1.fffffep-1f}) {
      const DirectionSample sample = environment.sample({u, v});
      EXPECT_TRUE(geometry::is_finite(sample.direction));
      EXPECT_TRUE(std::isfinite(sample.pdf) && sample.pdf > 0.0f);
    }
  }
}

TEST(Environment, AllBlack_StillSamples) {
  const Environment environment(4, 2, std::vector<Color>(8, Color(0.0f)));
  const DirectionSample sample = environment.sample({0.3f, 0.6f});
  EXPECT_GT(sample.pdf, 0.0f);
  EXPECT_EQ(environment.radiance(sample.direction), Color(0.0f));
}

TEST(StudioEnvironment, WhiteSurfaceFacingTheCamera_IsWellExposedAndNeutral) {
  const Environment studio = studio_environment();
  EXPECT_FALSE(studio.visible);
  const auto reflected = [&](const Vec3& normal) {
    return integrate(200, 400,
                     [&](const Vec3& d) {
                       const Color radiance = studio.radiance(d);
                       EXPECT_TRUE(geometry::is_finite(radiance) && radiance.x >= 0.0f);
                       return glm::dvec3(radiance * std::max(dot(d, normal), 0.0f));
                     }) /
           static_cast<double>(k_pi);
  };
  const glm::dvec3 front = reflected({0.0f, 0.0f, 1.0f});
  EXPECT_GT(front.y, 0.6);
  EXPECT_LT(front.y, 1.0);
  EXPECT_NEAR(front.x / front.y, 1.0, 0.03);
  EXPECT_NEAR(front.z / front.y, 1.0, 0.03);
  EXPECT_GT(reflected({-1.0f, 0.0f, 0.0f}).y, 1.2 * reflected({1.0f, 0.0f, 0.0f}).y);
  EXPECT_GT(reflected({0.0f, 1.0f, 0.0f}).y, 2.0 * reflected({0.0f, -1.0f, 0.0f}).y);
}

}  // namespace
}  // namespace lume::shading
