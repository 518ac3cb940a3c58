// SPDX-License-Identifier: Apache-2.0
// Whole files in and out of tests.
#pragma once

#include "tests/support/paths.h"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace lume::tests {

inline std::vector<std::byte> read_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<std::byte> bytes;
  for (std::istreambuf_iterator<char> i(file), end; i != end; ++i) {
    bytes.push_back(static_cast<std::byte>(*i));
  }
  return bytes;
}

inline void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// How many files a folder holds, hidden ones too.
inline std::ptrdiff_t count_files(const TemporaryFolder& folder) {
  return std::distance(std::filesystem::directory_iterator(folder.path()),
                       std::filesystem::directory_iterator());
}

}  // namespace lume::tests
