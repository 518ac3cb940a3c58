// SPDX-License-Identifier: Apache-2.0
// A renderer without a scene: pixels whose distribution is known, sampled as a renderer would.
#pragma once

#include "io/compare/estimates.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace lume::test {

/// Uniform numbers in [0, 1) by splitmix64 (Steele et al. 2014), fast enough for millions of them.
class Noise {
 public:
  /// Mixed, because states that differ by the generator's own step give the same numbers.
  explicit Noise(std::uint64_t seed) : state_(mix(mix(seed + 1))) {}

  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double exponential() { return -std::log1p(-uniform()); }
  double normal() {
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    // Box and Muller 1958.
    const double radius = std::sqrt(2.0 * exponential());
    const double angle = 2.0 * M_PI * uniform();
    spare_ = radius * std::sin(angle);
    has_spare_ = true;
    return radius * std::cos(angle);
  }
  double bernoulli(double probability, double value) {
    return uniform() < probability ? value : 0.0;
  }

 private:
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15u;
    return mix(state_);
  }

  std::uint64_t state_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

/// One sample of the pixel (x, y).
using Sampler = std::function<double(Noise& noise, int x, int y)>;

inline double gaussian_sample(Noise& noise, int, int) { return 1.0 + 0.5 * noise.normal(); }
inline double exponential_sample(Noise& noise, int, int) { return noise.exponential(); }
inline double lognormal_sample(Noise& noise, int, int) {
  constexpr double k_sigma = 1.5;  // a skewness of 33
  return std::exp(k_sigma * noise.normal() - 0.5 * k_sigma * k_sigma);
}
/// Light through a small hole: seldom found, then bright.
inline double hole_sample(Noise& noise, int, int) { return noise.bernoulli(0.02, 50.0); }
/// A surface with fireflies.
inline double firefly_sample(Noise& noise, int, int) {
  return 1.0 + 0.2 * noise.normal() + noise.bernoulli(1.0 / 2000.0, 1000.0);
}
/// Everything side by side: black, a constant, smooth and skewed noise, edges seen by half of the
/// samples, a hole with fireflies.
inline double texture_sample(Noise& noise, int x, int y) {
  switch (x / 6 % 6) {
    case 0:
      return 0.0;
    case 1:
      return 0.25 + 0.001 * y;
    case 2:
      return gaussian_sample(noise, x, y);
    case 3:
      return x % 6 == 0 ? noise.bernoulli(0.5, 2.0) : exponential_sample(noise, x, y);
    case 4:
      return hole_sample(noise, x, y);
    default:
      return firefly_sample(noise, x, y);
  }
}

struct Exposure {
  int images = 8;
  int samples = 1;  ///< per pixel and image
};

struct SyntheticPicture {
  int width = 48;
  int height = 36;

  [[nodiscard]] io::PictureShape shape() const { return {width, height, {"Y"}}; }
};

/// The mean of `samples` samples, and the variance of that mean.
inline std::pair<double, double> sample_pixel(const Sampler& sampler, Noise& noise, int x, int y,
                                              int samples) {
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double value = sampler(noise, x, y);
    sum += value;
    squares += value * value;
  }
  const double n = samples;
  const double spread = std::max(0.0, squares - sum * sum / n);
  return {sum / n, samples > 1 ? spread / (n * (n - 1.0)) : 0.0};
}

/// Calls set(i, mean, variance) for each pixel of one image.
template <class Set>
void render_synthetic(const Sampler& sampler, const SyntheticPicture& picture, int samples,
                      std::uint64_t seed, const Set& set) {
  Noise noise(seed);
  std::size_t i = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto [mean, variance] = sample_pixel(sampler, noise, x, y, samples);
      set(i++, static_cast<float>(mean), static_cast<float>(variance));
    }
  }
}

inline io::EstimateStack render_stack(const Sampler& sampler, const SyntheticPicture& picture,
                                      const Exposure& exposure, std::uint64_t seed) {
  io::EstimateStack stack{picture.shape(), {}, exposure.samples};
  for (int k = 0; k < exposure.images; ++k) {
    std::vector<float> plane(picture.shape().pixels());
    render_synthetic(sampler, picture, exposure.samples,
                     seed * 1000 + static_cast<std::uint64_t>(k),
                     [&](std::size_t i, float mean, float) { plane[i] = mean; });
    stack.images.push_back({std::move(plane)});
  }
  return stack;
}

inline io::EstimateMoments render_moments(const Sampler& sampler, const SyntheticPicture& picture,
                                          int samples, std::uint64_t seed) {
  std::vector<float> means(picture.shape().pixels());
  std::vector<float> variances(means.size());
  render_synthetic(sampler, picture, samples, seed, [&](std::size_t i, float mean, float variance) {
    means[i] = mean;
    variances[i] = variance;
  });
  return {picture.shape(), {std::move(means)}, {std::move(variances)}, samples};
}

}  // namespace lume::test
