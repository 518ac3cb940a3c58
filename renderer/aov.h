// SPDX-License-Identifier: Apache-2.0
// Arbitrary output variables: what else is known of the surface that a pixel shows, and of its
// light.
#pragma once

#include "geometry/camera.h"
#include "renderer/prepared_scene.h"
#include "renderer/radiance.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace lume::renderer {

enum class Aov {
  depth,
  position,
  normal,
  geometric_normal,
  albedo,
  instance,
  material,
  emitted,
  ambient,
  diffuse,
  specular,
  reflected,
  transmitted,
  shadow,
  recursion_depth,
  ray_count,
  nodes,
  primitive_tests
};

/// Where the values of an AOV come from.
enum class AovSource {
  center,   ///< the surface in the pixel's centre, once, because a mean of it means nothing
  surface,  ///< the surfaces of the pixel's samples, and what it took to find them, averaged like
            ///< the colour
  light     ///< what the integrator brought back, averaged like the colour
};

struct AovInfo {
  Aov aov;
  std::string_view name;                       ///< on the command line
  std::span<const std::string_view> channels;  ///< in an EXR
  AovSource source;
  std::string_view description;  ///< with units and frame
};

/// All AOVs, in the order of the enumeration.
[[nodiscard]] std::span<const AovInfo> aov_infos();
/// True for those that only an accelerator which counts_cost() can tell; 0 with others.
[[nodiscard]] constexpr bool is_of_cost(Aov aov) {
  return aov == Aov::nodes || aov == Aov::primitive_tests;
}

/// How many channels the AOVs have together.
[[nodiscard]] std::size_t channel_count(std::span<const Aov> aovs);

/// Writes the channels of all `aovs`, none of them of the light, one after the other, for the
/// surface that `ray` shows first; 0 where it shows none, but k_no_depth for depth, and what the
/// accelerator looked at for those of the cost.
void evaluate_aovs(std::span<const Aov> aovs, const PreparedScene& prepared,
                   const geometry::Camera& camera, const geometry::Ray& ray, std::span<float> out);

/// What a pixel's samples say of its light.
struct PixelLight {
  Radiance mean;
  float recursion_depth = 0.0f;  ///< mean of the deepest recursion of each sample
  float ray_count = 0.0f;        ///< mean rays of a sample, of all kinds
};

/// The same for AOVs of the light.
void evaluate_light_aovs(std::span<const Aov> aovs, const PixelLight& light, std::span<float> out);

/// Depth of the empty background: finite, so that pixels can be compared, and beyond any scene.
inline constexpr float k_no_depth = 1e10f;

}  // namespace lume::renderer
