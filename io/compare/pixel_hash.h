// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/compare/channel_image.h"

#include <string>

namespace lume::io {

/// XXH3 of 128 bits, in hex, over the decoded values of all images of a file, the names of their
/// channels (in whatever order they are stored) and their windows. Equal for equal pictures,
/// however they are compressed: a file's bytes change with the version of zlib.
[[nodiscard]] std::string pixel_hash(const ImageFile& file);

}  // namespace lume::io
