// SPDX-License-Identifier: Apache-2.0
// Rendered pictures in EXR files, written by Lume and read back without it.
#pragma once

#include "renderer/render.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lume::tests {

/// All channels of an image, interleaved, row 0 at the top.
struct ExrFile {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;
  std::vector<float> values;
};

/// Throws std::runtime_error with the reason.
[[nodiscard]] ExrFile read_exr(const std::filesystem::path& path);

/// Half precision, but for those AOVs that need more.
void write_exr(const std::filesystem::path& path, const renderer::Film& film);

}  // namespace lume::tests
