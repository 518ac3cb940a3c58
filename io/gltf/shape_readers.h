// SPDX-License-Identifier: Apache-2.0
// The shapes whose parameters are more than a few numbers, each in a file of its own. All throw
// Error(scene) with the place of what is wrong.
#pragma once

#include "geometry/shapes/shape.h"
#include "io/gltf/json_view.h"

namespace lume::io::gltf {

/// Metres. Beyond these a float's range or that of its square would end.
inline constexpr double k_max_length = 1e15;
inline constexpr Range k_length{.lower = 1e-15, .upper = k_max_length};
inline constexpr Range k_length_or_zero{.lower = 0.0, .upper = k_max_length};
inline constexpr Range k_coordinate{.lower = -k_max_length, .upper = k_max_length};

/// Three numbers.
[[nodiscard]] geometry::DVec3 read_point(const JsonView& point);

[[nodiscard]] geometry::Shape read_quadric(const JsonView& parameters);
[[nodiscard]] geometry::Shape read_polygon(const JsonView& parameters);
[[nodiscard]] geometry::Shape read_implicit(const JsonView& parameters);
[[nodiscard]] geometry::Shape read_bezier(const JsonView& parameters);

}  // namespace lume::io::gltf
