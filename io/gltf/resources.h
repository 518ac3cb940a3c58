// SPDX-License-Identifier: Apache-2.0
// The bytes that a glTF file refers to: data URIs and files beside it.
#pragma once

#include "io/gltf/json_view.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lume::io::gltf {

/// No file that is larger is read (4 GiB).
inline constexpr std::uintmax_t k_max_file_size = std::uintmax_t{1} << 32;

/// A whole regular file. Throws std::runtime_error with the reason alone ("does not exist").
[[nodiscard]] std::vector<std::byte> read_whole_file(const std::filesystem::path& path);

/// %41 becomes A; a percent sign that starts no such pair stays as it is.
[[nodiscard]] std::string percent_decode(std::string_view text);

/// RFC 4648, section 4; padding may be absent. Throws std::runtime_error.
[[nodiscard]] std::vector<std::byte> base64_decode(std::string_view text);

/// What the URI stands for: the content of a data URI, or of a file in `folder` or below it.
/// Absolute paths, other schemes and paths that lead out of the folder (also through links) are
/// refused. Throws Error(scene) with the URI's place.
[[nodiscard]] std::vector<std::byte> load_uri(const JsonView& uri,
                                              const std::filesystem::path& folder);

}  // namespace lume::io::gltf
