// SPDX-License-Identifier: Apache-2.0
// The binary container (glTF 2.0, section 4) and the first look at JSON text.
#pragma once

#include "io/gltf/json_view.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace lume::io::gltf {

using Bytes = std::span<const std::byte>;

/// A file's two parts, views into its bytes.
struct Chunks {
  Bytes json;
  std::optional<Bytes> binary;  ///< the BIN chunk
};

/// Tells a GLB from JSON text by its first bytes. Throws Error(scene) if the container's lengths or
/// types contradict the file.
[[nodiscard]] Chunks split_file(Bytes file, const std::string& path);

/// Parses JSON that is nested at most 64 levels deep. The depth is measured before any recursive
/// parser sees the text. Throws Error(scene).
[[nodiscard]] Json parse_json(Bytes bytes, const std::string& path);

}  // namespace lume::io::gltf
