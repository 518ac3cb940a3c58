// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/ray.h"
#include "renderer/ledger.h"
#include "renderer/prepared_scene.h"
#include "renderer/radiance.h"
#include "renderer/sampler.h"

#include <memory>
#include <span>
#include <string_view>

namespace lume::renderer {

struct IntegratorSettings {
  /// Reflections and refractions in a row; 0: only what the camera sees directly.
  int max_depth = 5;
  /// Rays that would count for less than this in the pixel are left out; 0: none.
  float cutoff = 1e-4f;
  bool shadows = true;
  /// How far surfaces keep ambient light from each other (metres); 0: not at all.
  float occlusion_distance = 0.0f;
};

/// An algorithm that finds the light along a camera ray.
class Integrator {
 public:
  Integrator() = default;
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;
  virtual ~Integrator() = default;

  /// The ray's direction must be a unit vector.
  [[nodiscard]] virtual Radiance radiance(const geometry::Ray& ray, const Sampler& sampler,
                                          Ledger& ledger) const = 0;
};

/// The names that make_integrator knows, default first.
[[nodiscard]] std::span<const std::string_view> integrator_names();
/// `prepared` must outlive the integrator. Throws std::invalid_argument for an unknown name.
[[nodiscard]] std::unique_ptr<Integrator> make_integrator(std::string_view name,
                                                          const PreparedScene& prepared,
                                                          const IntegratorSettings& settings);

}  // namespace lume::renderer
