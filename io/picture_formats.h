// SPDX-License-Identifier: Apache-2.0
// From a picture to the bytes of a file. Encoders work in memory, so that every error of the disk
// is seen by the one function that writes files.
#pragma once

#include "io/image_io.h"

#include <string>
#include <vector>

namespace lume::io {

using Bytes = std::vector<unsigned char>;

/// Each throws Error(input_output) with `name` if it cannot encode.
[[nodiscard]] Bytes encode_exr(const Picture& picture, const WriteOptions& options,
                               const std::string& name);
[[nodiscard]] Bytes encode_hdr(const Picture& picture, const std::string& name);
[[nodiscard]] Bytes encode_pfm(const Picture& picture);
/// `extension` is one of display_extensions().
[[nodiscard]] Bytes encode_display(const Picture& picture, const WriteOptions& options,
                                   const std::string& extension, const std::string& name);

}  // namespace lume::io
