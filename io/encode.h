// SPDX-License-Identifier: Apache-2.0
// Running one of OpenImageIO's writers on memory.
#pragma once

#include "io/picture_formats.h"

#include <OpenImageIO/imageio.h>

#include <functional>

namespace lume::io {

/// Opens OpenImageIO's writer of `format` with `spec`, lets `write` fill it, and returns the file.
/// `write` returns false for an error. Throws Error(input_output) with `name`.
[[nodiscard]] Bytes encode(const std::string& format, const OIIO::ImageSpec& spec,
                           const std::string& name,
                           const std::function<bool(OIIO::ImageOutput&)>& write);

/// Something like "Lume 1.2.3", for the metadata of files.
[[nodiscard]] std::string software_name();

}  // namespace lume::io
