// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace lume::cli {

/// The name with the last run of # in its file name (not its folders) replaced by the frame's
/// number, padded with zeros to the length of the run: "a.####.exr", 7 -> "a.0007.exr".
[[nodiscard]] std::filesystem::path frame_path(const std::filesystem::path& name, int frame);

}  // namespace lume::cli
