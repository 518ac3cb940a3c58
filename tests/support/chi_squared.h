// SPDX-License-Identifier: Apache-2.0
// Pearson's chi-squared test of a sampler against its density.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace lume::test {

/// Tests observed counts against expected ones. Cells expected to hold fewer than 5 are pooled, as
/// the statistic is no chi-squared one otherwise. By Wilson and Hilferty 1931 the cube root of the
/// statistic over its degrees of freedom is nearly normal; a sampler that is right fails with
/// probability 3e-7 (5 standard deviations), and each test is seeded, so it never does by chance.
inline void expect_chi_squared(std::span<const double> observed, std::span<const double> expected) {
  constexpr double k_least = 5.0;
  constexpr double k_sigmas = 5.0;
  double statistic = 0.0;
  double pooled_observed = 0.0;
  double pooled_expected = 0.0;
  int cells = 0;
  const auto add = [&](double o, double e) {
    statistic += (o - e) * (o - e) / e;
    ++cells;
  };
  for (std::size_t i = 0; i < observed.size(); ++i) {
    if (expected[i] >= k_least) {
      add(observed[i], expected[i]);
    } else {
      pooled_observed += observed[i];
      pooled_expected += expected[i];
    }
  }
  if (pooled_expected > 0.0) add(pooled_observed, std::max(pooled_expected, 1e-6));
  ASSERT_GT(cells, 10) << "too few cells to tell anything";
  const double degrees = cells - 1;
  const double spread = 2.0 / (9.0 * degrees);
  const double z = (std::cbrt(statistic / degrees) - (1.0 - spread)) / std::sqrt(spread);
  EXPECT_LT(z, k_sigmas) << "chi-squared " << statistic << " for " << degrees << " degrees";
}

/// Cells on the unit hemisphere or sphere by (cos theta, phi), in which a density per steradian can
/// be integrated and samples counted.
class SphereCells {
 public:
  SphereCells(int thetas, int phis, double lowest_z)
      : thetas_(thetas), phis_(phis), lowest_z_(lowest_z), counts_(size()), expected_(size()) {}

  template <class Direction>
  void count(const Direction& w) {
    const double phi = std::atan2(static_cast<double>(w.y), static_cast<double>(w.x));
    const double s = (static_cast<double>(w.z) - lowest_z_) / (1.0 - lowest_z_);
    const double t = phi / (2.0 * M_PI) + (phi < 0.0 ? 1.0 : 0.0);
    const int i = std::clamp(static_cast<int>(s * thetas_), 0, thetas_ - 1);
    const int j = std::clamp(static_cast<int>(t * phis_), 0, phis_ - 1);
    counts_[index(i, j)] += 1.0;
  }

  /// Fills in what `samples` draws from pdf(x, y, z) should count, by the midpoint rule on a grid
  /// of `steps`^2 points a cell. Returns the integral of the density over all cells.
  template <class Pdf>
  double expect(const Pdf& pdf, int samples, int steps) {
    double integral = 0.0;
    for (int i = 0; i < thetas_; ++i) {
      for (int j = 0; j < phis_; ++j) {
        double sum = 0.0;
        for (int k = 0; k < steps * steps; ++k) {
          const int row = k / steps;
          const double s = (i + (row + 0.5) / steps) / thetas_;
          const double t = (j + (k % steps + 0.5) / steps) / phis_;
          const double z = lowest_z_ + s * (1.0 - lowest_z_);
          const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
          sum += pdf(r * std::cos(2.0 * M_PI * t), r * std::sin(2.0 * M_PI * t), z);
        }
        const double solid_angle = 2.0 * M_PI * (1.0 - lowest_z_) / (thetas_ * phis_);
        const double probability = sum / (steps * steps) * solid_angle;
        integral += probability;
        expected_[index(i, j)] = probability * samples;
      }
    }
    return integral;
  }

  void test() const { expect_chi_squared(counts_, expected_); }

 private:
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(thetas_) * static_cast<std::size_t>(phis_);
  }
  [[nodiscard]] std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(phis_) +
           static_cast<std::size_t>(j);
  }

  int thetas_;
  int phis_;
  double lowest_z_;
  std::vector<double> counts_;
  std::vector<double> expected_;
};

}  // namespace lume::test
