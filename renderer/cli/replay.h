// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace lume::cli {

/// The command that renders pixel (x, y) again and nothing else, into replay.exr: `arguments` (what
/// followed `lume render`) without its outputs.
[[nodiscard]] std::string replay_command(const std::vector<std::string>& arguments, int x, int y);

}  // namespace lume::cli
