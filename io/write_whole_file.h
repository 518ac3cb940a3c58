// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace lume::io {

/// Writes a file that appears whole or not at all: under another name in the same folder, then
/// renamed. A symbolic link is followed. Throws Error(input_output), and then leaves nothing
/// behind.
void write_whole_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

}  // namespace lume::io
