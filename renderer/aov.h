// SPDX-License-Identifier: Apache-2.0
// Arbitrary output variables: what else is known of the surface that a pixel shows.
#pragma once

#include "geometry/camera.h"
#include "renderer/prepared_scene.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace lume::renderer {

enum class Aov { depth, position, normal, geometric_normal, albedo, instance, material };

struct AovInfo {
  Aov aov;
  std::string_view name;                       ///< on the command line
  std::span<const std::string_view> channels;  ///< in an EXR
  /// Taken once, through the pixel's centre, because a mean of it means nothing; others are
  /// averaged over the pixel's samples like the colour.
  bool at_center;
  std::string_view description;  ///< with units and frame
};

/// All AOVs, in the order of the enumeration.
[[nodiscard]] std::span<const AovInfo> aov_infos();

/// How many channels the AOVs have together.
[[nodiscard]] std::size_t channel_count(std::span<const Aov> aovs);

/// Writes the channels of all `aovs`, one after the other, for the surface that `ray` shows first;
/// 0 where it shows none, but k_no_depth for depth.
void evaluate_aovs(std::span<const Aov> aovs, const PreparedScene& prepared,
                   const geometry::Camera& camera, const geometry::Ray& ray, std::span<float> out);

/// Depth of the empty background: finite, so that pixels can be compared, and beyond any scene.
inline constexpr float k_no_depth = 1e10f;

}  // namespace lume::renderer
