// SPDX-License-Identifier: Apache-2.0
// What OpenImageIO does not check before it allocates or after it has decoded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace lume::io {

/// Throws Error(input_output) for an image that is empty, larger than 2^28 pixels, or larger than
/// `file_bytes` bytes could ever hold: a lie in its header.
void check_image_size(std::int64_t width, std::int64_t height, std::uintmax_t file_bytes,
                      const std::string& name);

/// True if the bytes begin as a JPEG does.
[[nodiscard]] bool is_jpeg(std::span<const std::byte> bytes);

/// True if the JPEG reaches its end-of-image marker; the decoder paints missing parts grey and says
/// nothing. What follows the marker does not matter.
[[nodiscard]] bool is_complete_jpeg(std::span<const std::byte> bytes);

}  // namespace lume::io
