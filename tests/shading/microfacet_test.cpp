// SPDX-License-Identifier: Apache-2.0
#include "shading/microfacet.h"

#include "tests/support/chi_squared.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

namespace lume::shading {
namespace {

using test::Random;

/// Integral over the hemisphere of f(h), by the midpoint rule in (theta, phi) with theta = s^2
/// pi/2, which puts points where narrow lobes need them.
template <class F>
double integrate_hemisphere(const F& f) {
  constexpr int k_thetas = 4000;
  constexpr int k_phis = 64;
  double sum = 0.0;
  for (int i = 0; i < k_thetas; ++i) {
    const double s = (i + 0.5) / k_thetas;
    const double theta = s * s * M_PI / 2.0;
    const double width = s * M_PI / k_thetas * (2.0 * M_PI / k_phis);
    for (int j = 0; j < k_phis; ++j) {
      const double phi = (j + 0.5) / k_phis * 2.0 * M_PI;
      const Vec3 h(static_cast<float>(std::sin(theta) * std::cos(phi)),
                   static_cast<float>(std::sin(theta) * std::sin(phi)),
                   static_cast<float>(std::cos(theta)));
      sum += f(h) * std::sin(theta) * width;
    }
  }
  return sum;
}

TEST(Ggx, Distribution_ProjectsToOne) {
  for (const float alpha : {0.01f, 0.05f, 0.3f, 1.0f}) {
    const double integral = integrate_hemisphere(
        [&](const Vec3& h) { return static_cast<double>(ggx_distribution(h, alpha) * h.z); });
    EXPECT_NEAR(integral, 1.0, 2e-3) << "alpha " << alpha;
  }
}

TEST(Ggx, Masking_ConservesTheVisibleArea) {
  // Heitz 2014, eq. 14: the visible microfacets' projected area is the macroscopic one, cos(v).
  for (const float alpha : {0.05f, 0.3f, 1.0f}) {
    for (const float cosine : {0.1f, 0.5f, 0.95f}) {
      const Vec3 v(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
      const double area = integrate_hemisphere([&](const Vec3& h) {
        return static_cast<double>(smith_masking(v, alpha) * std::max(0.0f, dot(v, h)) *
                                   ggx_distribution(h, alpha));
      });
      EXPECT_NEAR(area, cosine, 4e-3 * cosine) << "alpha " << alpha << " cosine " << cosine;
    }
  }
}

TEST(Ggx, MaskingShadowing_IsSymmetricAndBelowEither) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    Vec3 a = random.direction();
    Vec3 b = random.direction();
    a.z = std::abs(a.z) + 1e-4f;
    b.z = std::abs(b.z) + 1e-4f;
    const float alpha = random.uniform(0.01f, 1.0f);
    const float g = smith_masking_shadowing(a, b, alpha);
    ASSERT_FLOAT_EQ(g, smith_masking_shadowing(b, a, alpha));
    ASSERT_LE(g, std::min(smith_masking(a, alpha), smith_masking(b, alpha)) * 1.00001f);
    ASSERT_GE(g, smith_masking(a, alpha) * smith_masking(b, alpha) * 0.99999f);
  }
}

TEST(Ggx, VisibleNormals_FollowTheirDensity) {
  constexpr int k_samples = 200000;
  Random random(2);
  for (const float alpha : {0.2f, 0.6f, 1.0f}) {
    for (const float cosine : {0.15f, 0.7f, 1.0f}) {
      const Vec3 v(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
      test::SphereCells cells(20, 20, 0.0);
      for (int i = 0; i < k_samples; ++i) {
        cells.count(sample_visible_normal(v, alpha, random.square()));
      }
      const double integral = cells.expect(
          [&](double x, double y, double z) {
            const Vec3 h(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
            return static_cast<double>(visible_normal_pdf(v, h, alpha));
          },
          k_samples, 16);
      EXPECT_NEAR(integral, 1.0, 5e-3) << "alpha " << alpha << " cosine " << cosine;
      cells.test();
    }
  }
}

TEST(Ggx, SampledNormals_AreUnitAndAboveTheSurface) {
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    Vec3 v = random.direction();
    v.z = std::abs(v.z) + 1e-6f;
    v = glm::normalize(v);
    const Vec3 h = sample_visible_normal(v, random.uniform(0.001f, 1.0f), random.square());
    ASSERT_NEAR(length(h), 1.0f, 1e-5f);
    ASSERT_GE(h.z, 0.0f);
    ASSERT_GE(dot(h, v), -1e-5f);
  }
}

}  // namespace
}  // namespace lume::shading
