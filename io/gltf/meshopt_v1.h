// SPDX-License-Identifier: Apache-2.0
// Version 1 of meshoptimizer's codec for vertex attributes, which came after Debian's library.
#pragma once

#include "io/gltf/glb.h"

#include <cstddef>

namespace lume::io::gltf {

/// Decodes `count` elements of `stride` bytes (a multiple of 4 in [4, 256]) to `out`, by
/// KHR_meshopt_compression, appendix A, mode 0. False if the stream is not valid.
[[nodiscard]] bool decode_meshopt_v1(std::byte* out, std::size_t count, std::size_t stride,
                                     Bytes data);

}  // namespace lume::io::gltf
