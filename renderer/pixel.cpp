// SPDX-License-Identifier: Apache-2.0
#include "renderer/pixel.h"

#include <algorithm>
#include <cmath>

namespace lume::renderer {
namespace {

enum Dimension : std::uint32_t { k_filter, k_lens };
constexpr std::uint32_t k_path_branch = 1;

/// `offset` from the pixel's middle in pixels, `lens` two random numbers.
geometry::Ray camera_ray(const PixelSettings& settings, const geometry::Camera& camera, int x,
                         int y, Vec2 offset, Vec2 lens) {
  const Vec2 size(static_cast<float>(settings.width), static_cast<float>(settings.height));
  const Vec2 pixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
  return camera.generate_ray((pixel + offset) / size, size.x / size.y, lens);
}

/// A sum of all parts is finite only if each of them is.
bool is_finite(const Radiance& r) {
  return geometry::is_finite(r.color() + r.shadow) && std::isfinite(r.alpha);
}

}  // namespace

CameraSample camera_sample(const PixelSettings& settings, const geometry::Camera& camera, int x,
                           int y, std::uint32_t sample) {
  const Sampler sampler(settings.seed, x, y, sample);
  const Vec2 offset = settings.filter.sample(sampler.get_2d(k_filter));
  const Vec2 lens = camera.lens_radius > 0.0f ? sampler.get_2d(k_lens) : Vec2(0.5f);
  return {camera_ray(settings, camera, x, y, offset, lens), sampler.branch(k_path_branch)};
}

geometry::Ray center_ray(const PixelSettings& settings, const geometry::Camera& camera, int x,
                         int y) {
  return camera_ray(settings, camera, x, y, Vec2(0.0f), Vec2(0.5f));
}

bool PixelMean::add(const Radiance& sample, std::uint64_t rays) {
  rays_ += rays;
  if (!is_finite(sample)) return false;
  sum_.terms += sample.terms;
  sum_.shadow += sample.shadow;
  sum_.alpha += sample.alpha;
  sum_.depth = std::max(sum_.depth, sample.depth);
  depths_ += static_cast<std::uint64_t>(sample.depth);
  return true;
}

PixelLight PixelMean::light(std::uint32_t count) const {
  const float scale = 1.0f / static_cast<float>(count);
  return {{Color(scale) * sum_.terms, scale * sum_.shadow, scale * sum_.alpha, sum_.depth},
          static_cast<float>(depths_) / static_cast<float>(count),
          static_cast<float>(rays_) / static_cast<float>(count)};
}

PixelTrace trace_pixel(const geometry::Camera& camera, const Integrator& integrator,
                       const PixelSettings& settings, int x, int y) {
  PixelTrace trace;
  PixelMean mean;
  for (std::uint32_t s = 0; s < settings.spp; ++s) {
    Ledger ledger{.counts = {}, .tree = &trace.samples.emplace_back()};
    const CameraSample sample = camera_sample(settings, camera, x, y, s);
    const Radiance radiance = integrator.radiance(sample.ray, sample.sampler, ledger);
    mean.add(radiance, ledger.counts.total());
    trace.sums.push_back(radiance);
    trace.rays += ledger.counts;
  }
  trace.value = mean.light(settings.spp).mean;
  return trace;
}

}  // namespace lume::renderer
