// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/ray.h"
#include "renderer/prepared_scene.h"
#include "renderer/ray_counts.h"
#include "renderer/sampler.h"
#include "shading/color.h"

#include <memory>
#include <span>
#include <string_view>

namespace lume::renderer {

using shading::Color;

/// What one camera ray brings back.
struct Radiance {
  Color color{0.0f};   ///< nits, already weighted by coverage (associated alpha)
  float alpha = 0.0f;  ///< coverage: 0 where nothing was met and no backdrop shows
};

struct IntegratorSettings {
  int max_depth =
      5;  ///< reflections and refractions in a row; 0: only what the camera sees directly
};

/// An algorithm that finds the light along a camera ray.
class Integrator {
 public:
  Integrator() = default;
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;
  virtual ~Integrator() = default;

  [[nodiscard]] virtual Radiance radiance(const geometry::Ray& ray, const Sampler& sampler,
                                          RayCounts& counts) const = 0;
};

/// The names that make_integrator knows, default first.
[[nodiscard]] std::span<const std::string_view> integrator_names();
/// `prepared` must outlive the integrator. Throws std::invalid_argument for an unknown name.
[[nodiscard]] std::unique_ptr<Integrator> make_integrator(std::string_view name,
                                                          const PreparedScene& prepared,
                                                          const IntegratorSettings& settings);

}  // namespace lume::renderer
