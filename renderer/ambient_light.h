// SPDX-License-Identifier: Apache-2.0
// The course's ambient term, with ambient occlusion where it is asked for.
#pragma once

#include "renderer/direct_light.h"

namespace lume::renderer {

struct AmbientLight {
  Color color{0.0f};        ///< the term (nits)
  float unoccluded = 1.0f;  ///< part of the directions that are free, or one drawn from them
};

/// L_a k_a O_a, darkened by the material's occlusion map. With a `distance` above 0 (metres) also
/// by one ray to see whether anything stands within it, in a direction drawn by the cosine: over
/// the samples of a pixel that is ambient occlusion (Zhukov, Iones, Kronin 1998, "An Ambient Light
/// Illumination Model"; Landis 2002, "Production-Ready Global Illumination"). Uses dimension 3 of
/// the sampler.
[[nodiscard]] AmbientLight ambient_light(const PreparedScene& prepared, const ShadedPoint& point,
                                         float distance, const Sampler& sampler, RayCounts& counts);

}  // namespace lume::renderer
