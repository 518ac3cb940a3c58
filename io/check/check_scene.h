// SPDX-License-Identifier: Apache-2.0
// Looks a scene over before it is rendered: is the file valid, and does it say what its author
// probably meant?
#pragma once

#include "io/check/finding.h"

#include <filesystem>
#include <vector>

namespace lume::io::check {

/// All that is wrong or suspicious. A file that is refused gives its one error and nothing else.
/// Throws Error(input_output) if the file itself cannot be read.
[[nodiscard]] std::vector<Finding> check_scene(const std::filesystem::path& path);

}  // namespace lume::io::check
