// SPDX-License-Identifier: Apache-2.0
// One pixel: its samples, and what becomes of them. Renders and traces of rays both go through
// here, so that what is explained is what was rendered.
#pragma once

#include "geometry/camera.h"
#include "renderer/aov.h"
#include "renderer/integrator.h"
#include "renderer/pixel_filter.h"
#include "renderer/ray_tree.h"

#include <cstdint>
#include <vector>

namespace lume::renderer {

/// What all pixels have in common.
struct PixelSettings {
  int width = 1280;  ///< pixels of the whole image
  int height = 720;
  std::uint32_t spp = 16;  ///< samples a pixel
  std::uint64_t seed = 0;
  PixelFilter filter;
};

/// A camera ray, and the random numbers of the path behind it.
struct CameraSample {
  geometry::Ray ray;
  Sampler sampler{0, 0, 0, 0};
};

[[nodiscard]] CameraSample camera_sample(const PixelSettings& settings,
                                         const geometry::Camera& camera, int x, int y,
                                         std::uint32_t sample);

/// The ray through the middle of the pixel and of the lens.
[[nodiscard]] geometry::Ray center_ray(const PixelSettings& settings,
                                       const geometry::Camera& camera, int x, int y);

/// The mean of samples, added up in their order.
class PixelMean {
 public:
  /// `rays`: how many were traced for the sample. False, and nothing but the rays added, for one
  /// that is infinite or NaN: it counts as black.
  bool add(const Radiance& sample, std::uint64_t rays);

  /// `count` samples were taken.
  [[nodiscard]] PixelLight light(std::uint32_t count) const;

 private:
  Radiance sum_;
  std::uint64_t depths_ = 0;
  std::uint64_t rays_ = 0;
};

/// A pixel with all its rays.
struct PixelTrace {
  std::vector<RayTree> samples;
  std::vector<Radiance> sums;  ///< what each sample brought back
  Radiance value;              ///< as render_image finds it
  RayCounts rays;
};

[[nodiscard]] PixelTrace trace_pixel(const geometry::Camera& camera, const Integrator& integrator,
                                     const PixelSettings& settings, int x, int y);

}  // namespace lume::renderer
