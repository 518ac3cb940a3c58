// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lume::cli {

/// Copies a file, which appears whole or not at all. Throws io::Error.
void copy_whole(const std::filesystem::path& from, const std::filesystem::path& to);

/// Makes the folder and those above it. Throws io::Error.
void make_folder(const std::filesystem::path& folder);

/// The last lines of a text file, at most so many, without control characters; none if it cannot be
/// read.
[[nodiscard]] std::vector<std::string> last_lines(const std::filesystem::path& file,
                                                  std::size_t most);

}  // namespace lume::cli
