// SPDX-License-Identifier: Apache-2.0
// What it takes to compare two pictures of 1920 x 1080 by perception: FLIP, HDR-FLIP at ten
// exposures, its summary, and SSIM. `Mpixel/s` counts pixels of one of both pictures.
#include "io/compare/flip_hdr.h"
#include "io/compare/flip_summary.h"
#include "io/compare/ssim.h"
#include "tests/support/random.h"

#include <benchmark/benchmark.h>

#include <array>
#include <vector>

namespace lume::io {
namespace {

constexpr int k_width = 1920;
constexpr int k_height = 1080;

/// Different all over: nothing is gained from pixels that are equal.
const RgbImage& picture(unsigned seed) {
  static const std::array<RgbImage, 2> k_pictures = [] {
    std::array<RgbImage, 2> made;
    for (unsigned i = 0; i < 2; ++i) {
      test::Random random(i);
      made[i] = {k_width, k_height, std::vector<shading::Color>(k_width * k_height)};
      for (shading::Color& pixel : made[i].pixels) pixel = 0.5f + random.cube(0.5f);
    }
    return made;
  }();
  return k_pictures[seed];
}

template <class Compare>
void measure(benchmark::State& state, const Compare& compare) {
  picture(0);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(compare());
  state.counters["Mpixel/s"] =
      benchmark::Counter(1e-6 * k_width * k_height, benchmark::Counter::kIsIterationInvariantRate);
}

void flip_1080p(benchmark::State& state) {
  measure(state, [] { return flip(picture(0), picture(1)); });
}

void flip_hdr_1080p(benchmark::State& state) {
  const FlipExposures exposures{-8.0, 1.0, 10};
  measure(state, [&] { return flip_hdr(picture(0), picture(1), exposures); });
}

void flip_summary_1080p(benchmark::State& state) {
  const std::vector<float> errors = flip(picture(0), picture(1));
  measure(state, [&] { return summarize_flip(errors); });
}

void ssim_1080p(benchmark::State& state) {
  measure(state, [] { return ssim(picture(0), picture(1)); });
}

BENCHMARK(flip_1080p)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(flip_hdr_1080p)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(flip_summary_1080p)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(ssim_1080p)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace lume::io
