// SPDX-License-Identifier: Apache-2.0
// Shadow rays of the ray sets: to which light, and which way.
#pragma once

#include "geometry/ray.h"
#include "geometry/surface_point.h"
#include "renderer/prepared_scene.h"
#include "renderer/sampler.h"

#include <cstddef>
#include <optional>

namespace lume::renderer {

/// Aims at the punctual lights and the emissive surfaces of a scene, or in a few fixed directions
/// above where there are none of either.
class RayAim {
 public:
  /// `prepared` must outlive this.
  explicit RayAim(const PreparedScene& prepared);

  /// A shadow ray to light number `choice` modulo their count, or to the first one after it that
  /// sends light to the visible side of the surface; nothing if none does.
  [[nodiscard]] std::optional<geometry::Ray> aim(const geometry::SurfacePoint& point,
                                                 std::size_t choice, const Sampler& sampler) const;

 private:
  [[nodiscard]] std::optional<geometry::Ray> aim_at(const geometry::SurfacePoint& point,
                                                    std::size_t light,
                                                    const Sampler& sampler) const;

  const PreparedScene& prepared_;
  std::size_t lights_;  ///< all emissive surfaces count as one, after the punctual lights
  bool fixed_;          ///< there are no lights: directions instead
};

}  // namespace lume::renderer
