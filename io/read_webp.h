// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shading/image.h"

#include <cstddef>
#include <span>
#include <string>

namespace lume::io {

[[nodiscard]] bool is_webp(std::span<const std::byte> bytes);

/// As decode_image(), for a WebP; without texels if only its size is wanted.
[[nodiscard]] shading::Image read_webp(std::span<const std::byte> bytes, const std::string& name,
                                       bool with_texels);

}  // namespace lume::io
