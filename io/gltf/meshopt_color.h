// SPDX-License-Identifier: Apache-2.0
// The filter COLOR of KHR_meshopt_compression, which came after Debian's meshoptimizer.
#pragma once

#include <cstddef>

namespace lume::io::gltf {

/// In place: `count` elements of four components, 8 or 16 bits each by `stride` (4 or 8 bytes),
/// from YCoCg of K bits to normalized RGBA (KHR_meshopt_compression, appendix B, filter 4).
void decode_meshopt_colors(std::byte* data, std::size_t count, std::size_t stride);

}  // namespace lume::io::gltf
