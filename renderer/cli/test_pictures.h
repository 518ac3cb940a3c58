// SPDX-License-Identifier: Apache-2.0
// Pictures of the results of `lume test`.
#pragma once

#include <filesystem>
#include <vector>

namespace lume::cli {

/// Writes a map of FLIP, in [0, 1], as a picture: dark where the images are alike. Throws
/// io::Error.
void write_flip_map(const std::filesystem::path& file, const std::vector<float>& flip_map,
                    int width, int height);

}  // namespace lume::cli
