// SPDX-License-Identifier: Apache-2.0
// The proof that what is explained is what was rendered.
#include "renderer/cli/trace_report.h"

#include <bit>
#include <cmath>

namespace lume::cli {
namespace {

using renderer::LightTerms;
using shading::Color;

/// NaNs count as equal whatever their bits, which depend on the order of operands.
bool are_same(const Color& a, const Color& b) {
  for (int i = 0; i < 3; ++i) {
    const bool same = std::bit_cast<std::uint32_t>(a[i]) == std::bit_cast<std::uint32_t>(b[i]);
    if (!same && !(std::isnan(a[i]) && std::isnan(b[i]))) return false;
  }
  return true;
}

bool are_same(const LightTerms& a, const LightTerms& b) {
  return are_same(a.emitted, b.emitted) && are_same(a.ambient, b.ambient) &&
         are_same(a.diffuse, b.diffuse) && are_same(a.specular, b.specular) &&
         are_same(a.reflected, b.reflected) && are_same(a.transmitted, b.transmitted);
}

}  // namespace

bool adds_up(const renderer::PixelTrace& trace) {
  renderer::PixelMean mean;
  for (std::size_t i = 0; i < trace.samples.size(); ++i) {
    renderer::Radiance sum = trace.sums[i];
    sum.terms = resum(trace.samples[i]);
    if (!are_same(sum.terms, trace.sums[i].terms)) return false;
    mean.add(sum, 0);
  }
  const auto count = static_cast<std::uint32_t>(trace.samples.size());
  return are_same(mean.light(count).mean.terms, trace.value.terms);
}

}  // namespace lume::cli
