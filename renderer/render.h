// SPDX-License-Identifier: Apache-2.0
// The picture: tiles in parallel, pixels in a tile, samples in a pixel.
#pragma once

#include "geometry/camera.h"
#include "renderer/aov.h"
#include "renderer/film.h"
#include "renderer/integrator.h"
#include "renderer/pixel.h"
#include "renderer/prepared_scene.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

namespace lume::renderer {

struct RenderSettings : PixelSettings {
  shading::PixelRegion region;  ///< the part to render; empty: all of it
  std::vector<Aov> aovs;
};

/// How a render is watched and stopped; both optional.
struct RenderControl {
  /// Called with the fraction of the work that is done, 0..1, never from two threads at once.
  std::function<void(double)> on_progress;
  /// When it turns true, pixels that have not begun stay empty.
  const std::atomic<bool>* cancel = nullptr;
};

/// Samples that came out infinite or NaN. They count as black in the picture.
struct NonFiniteSamples {
  std::uint64_t count = 0;
  int x = 0;  ///< the first one in scan order; --crop 1x1+x+y and the seed replay it
  int y = 0;
  std::uint32_t sample = 0;
};

struct RenderResult {
  Film film;
  RayCounts rays;
  NonFiniteSamples non_finite;
  bool cancelled = false;
};

/// Depends on its arguments only, not on the number of threads.
[[nodiscard]] RenderResult render_image(const PreparedScene& prepared,
                                        const geometry::Camera& camera,
                                        const Integrator& integrator,
                                        const RenderSettings& settings,
                                        const RenderControl& control = {});

}  // namespace lume::renderer
