// SPDX-License-Identifier: Apache-2.0
#include "io/compare/flip_filters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lume::io {
namespace {

using std::numbers::pi;

/// A Gaussian of the contrast sensitivity functions: a sqrt(pi / b) exp(-pi^2 d^2 / b) at a
/// distance of d degrees.
struct Sensitivity {
  double a = 0.0;
  double b = 1.0;

  [[nodiscard]] double height() const { return a * std::sqrt(pi / b); }
  /// Standard deviation in degrees.
  [[nodiscard]] double deviation() const { return std::sqrt(b / (2.0 * pi * pi)); }
};
constexpr Sensitivity k_achromatic{1.0, 0.0047};
constexpr Sensitivity k_red_green{1.0, 0.0053};
constexpr Sensitivity k_blue_yellow_wide{34.1, 0.04};
constexpr Sensitivity k_blue_yellow_narrow{13.5, 0.025};

/// Peak to trough of the detector of edges, in degrees: w.
constexpr double k_edge_width = 0.082;

std::size_t radius_of(double deviation) {
  return static_cast<std::size_t>(std::ceil(3.0 * deviation));
}

double sum(const Kernel& kernel) {
  double right = 0.0;
  for (const double weight : kernel.right) right += weight;
  return kernel.center + 2.0 * right;
}

Kernel scaled(Kernel kernel, double factor) {
  kernel.center *= factor;
  for (double& weight : kernel.right) weight *= factor;
  return kernel;
}

/// Not normalized: 1 in the middle.
Kernel gaussian(double deviation, std::size_t radius) {
  Kernel kernel{1.0, std::vector<double>(radius), false};
  for (std::size_t i = 0; i < radius; ++i) {
    const double x = static_cast<double>(i + 1) / deviation;
    kernel.right[i] = std::exp(-0.5 * x * x);
  }
  return kernel;
}

/// The Gaussian, whose weights sum to `weight` in two dimensions.
SeparableKernel blur(const Kernel& kernel, double weight) {
  const double total = sum(kernel);
  return {scaled(kernel, 1.0 / total), scaled(kernel, weight / total)};
}

/// Positive weights sum to 1 and negative ones to -1, separately.
Kernel edge_detector(const Kernel& gaussian) {
  Kernel kernel{0.0, gaussian.right, true};
  double total = 0.0;
  for (std::size_t i = 0; i < kernel.right.size(); ++i) {
    kernel.right[i] *= static_cast<double>(i + 1);
    total += kernel.right[i];
  }
  return scaled(kernel, -1.0 / total);
}

Kernel point_detector(const Kernel& gaussian, double deviation) {
  Kernel kernel{-1.0, gaussian.right, false};
  double positive = 0.0;
  double negative = -1.0;
  for (std::size_t i = 0; i < kernel.right.size(); ++i) {
    const double x = static_cast<double>(i + 1) / deviation;
    kernel.right[i] *= x * x - 1.0;
    (kernel.right[i] < 0.0 ? negative : positive) += 2.0 * kernel.right[i];
  }
  kernel.center /= -negative;
  for (double& weight : kernel.right) weight /= weight < 0.0 ? -negative : positive;
  return kernel;
}

/// What is left and right of (or above and below) a run of values, `distance` away.
struct Neighbours {
  const double* before;
  const double* after;
};

template <bool Odd>
double pair_sum(const Neighbours& pair, std::size_t x) {
  return Odd ? pair.after[x] - pair.before[x] : pair.before[x] + pair.after[x];
}

/// Adds four pairs of weights at a time, so that `out` is seldom loaded and stored.
template <bool Odd, typename NeighboursAt>
void add_pairs(const Kernel& kernel, const NeighboursAt& at, std::size_t count, double* out) {
  const std::vector<double>& w = kernel.right;
  std::size_t k = 0;
  for (; k + 4 <= w.size(); k += 4) {
    const std::array<double, 4> v = {w[k], w[k + 1], w[k + 2], w[k + 3]};
    const std::array<Neighbours, 4> n = {at(k + 1), at(k + 2), at(k + 3), at(k + 4)};
    for (std::size_t x = 0; x < count; ++x) {
      out[x] += (v[0] * pair_sum<Odd>(n[0], x) + v[1] * pair_sum<Odd>(n[1], x)) +
                (v[2] * pair_sum<Odd>(n[2], x) + v[3] * pair_sum<Odd>(n[3], x));
    }
  }
  for (; k < w.size(); ++k) {
    const double v = w[k];
    const Neighbours n = at(k + 1);
    for (std::size_t x = 0; x < count; ++x) out[x] += v * pair_sum<Odd>(n, x);
  }
}

template <typename NeighboursAt>
void filter_run(const Kernel& kernel, const double* middle, const NeighboursAt& at,
                std::size_t count, double* out) {
  for (std::size_t x = 0; x < count; ++x) out[x] = kernel.center * middle[x];
  if (kernel.odd) {
    add_pairs<true>(kernel, at, count, out);
  } else {
    add_pairs<false>(kernel, at, count, out);
  }
}

}  // namespace

FlipKernels make_flip_kernels(double pixels_per_degree) {
  FlipKernels kernels;
  // All have the radius of the widest, as the paper has it.
  const std::size_t radius = radius_of(k_blue_yellow_wide.deviation() * pixels_per_degree);
  const auto of = [&](const Sensitivity& sensitivity) {
    return gaussian(sensitivity.deviation() * pixels_per_degree, radius);
  };
  kernels.achromatic = blur(of(k_achromatic), 1.0);
  kernels.red_green = blur(of(k_red_green), 1.0);

  const Kernel wide = of(k_blue_yellow_wide);
  const Kernel narrow = of(k_blue_yellow_narrow);
  const double wide_weight = k_blue_yellow_wide.height() * sum(wide) * sum(wide);
  const double narrow_weight = k_blue_yellow_narrow.height() * sum(narrow) * sum(narrow);
  const double weight = wide_weight + narrow_weight;
  kernels.blue_yellow_wide = blur(wide, wide_weight / weight);
  kernels.blue_yellow_narrow = blur(narrow, narrow_weight / weight);

  const double deviation = 0.5 * k_edge_width * pixels_per_degree;
  const Kernel bell = gaussian(deviation, radius_of(deviation));
  kernels.smooth = scaled(bell, 1.0 / sum(bell));
  kernels.edge = edge_detector(bell);
  kernels.point = point_detector(bell, deviation);
  kernels.radius = std::max(radius, bell.right.size());
  return kernels;
}

void filter_across(const Plane& in, const Kernel& kernel, std::size_t margin, Plane& out) {
  out.resize(in.width - 2 * margin, in.height);
  for (std::size_t y = 0; y < out.height; ++y) {
    const double* middle = in.row(y) + margin;
    const auto at = [middle](std::size_t distance) {
      return Neighbours{middle - distance, middle + distance};
    };
    filter_run(kernel, middle, at, out.width, out.row(y));
  }
}

void filter_down(const Plane& in, const Kernel& kernel, std::size_t margin, Plane& out) {
  out.resize(in.width, in.height - 2 * margin);
  for (std::size_t y = 0; y < out.height; ++y) {
    const auto at = [&in, middle = y + margin](std::size_t distance) {
      return Neighbours{in.row(middle - distance), in.row(middle + distance)};
    };
    filter_run(kernel, in.row(y + margin), at, out.width, out.row(y));
  }
}

}  // namespace lume::io
