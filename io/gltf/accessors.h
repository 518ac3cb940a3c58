// SPDX-License-Identifier: Apache-2.0
// The values of accessors: every component type, normalized integers, interleaving, sparse
// replacements, and zeros where there is no buffer view (glTF 2.0, section 3.6.2).
#pragma once

#include "geometry/math.h"
#include "io/gltf/document.h"

#include <cstdint>
#include <vector>

namespace lume::io::gltf {

/// The accessor must have as many components as the vector; integers that are not normalized keep
/// their value. Throws Error(scene) for a sparse index beyond the accessor's count.
[[nodiscard]] std::vector<geometry::Vec2> read_vec2(const Document& document, std::size_t accessor);
[[nodiscard]] std::vector<geometry::Vec3> read_vec3(const Document& document, std::size_t accessor);
[[nodiscard]] std::vector<geometry::Vec4> read_vec4(const Document& document, std::size_t accessor);

/// A scalar accessor of an unsigned type.
[[nodiscard]] std::vector<std::uint32_t> read_indices(const Document& document,
                                                      std::size_t accessor);

/// Every component of every element, one after another, in double. For accessors whose columns have
/// no padding: vectors of any type, matrices of floats.
[[nodiscard]] std::vector<double> read_numbers(const Document& document, std::size_t accessor);

}  // namespace lume::io::gltf
