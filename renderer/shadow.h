// SPDX-License-Identifier: Apache-2.0
// How much of a light arrives: shadow rays, which see-through surfaces colour instead of stopping.
#pragma once

#include "renderer/prepared_scene.h"
#include "renderer/ray_counts.h"
#include "shading/color.h"

namespace lume::renderer {

/// The part of the light that arrives along a shadow ray.
struct Transmittance {
  /// Through everything, bending nowhere: alpha-blended surfaces let 1 - alpha pass, transmissive
  /// ones their base colour less the Fresnel reflection, and solids absorb on the way
  /// (Beer-Lambert).
  shading::Color color{1.0f};
  /// A transmissive surface was crossed. A reflection ray would have been bent or mirrored there,
  /// so whoever combines both must not count this light twice.
  bool through_transmissive = false;
};

/// Light that comes from behind a one-way surface passes it too. The ray runs against the light, so
/// it meets such a surface on its front.
[[nodiscard]] Transmittance trace_shadow(const PreparedScene& prepared, geometry::Ray ray,
                                         RayCounts& counts);

/// Beer-Lambert absorption of a solid's material over a distance (metres), KHR_materials_volume:
/// attenuation_color^(distance / attenuation_distance).
[[nodiscard]] shading::Color absorb(const shading::Material& material, float distance);

}  // namespace lume::renderer
