// SPDX-License-Identifier: Apache-2.0
// Rays in a file, so that another program, or another version of this one, can be asked the very
// same questions; docs/bench.md describes the format byte by byte.
#pragma once

#include "geometry/ray.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace lume::io {

/// Rays of one kind, in the frame of the scene they were made for.
struct RayList {
  std::string name;       ///< printable ASCII, 1 to 64 characters
  bool any_hit = false;   ///< what is asked is whether anything is met
  bool coherent = false;  ///< each run of 16 runs much alike
  std::vector<geometry::Ray> rays;
};

/// The file appears whole or not at all. Throws Error(input_output).
void write_rays(const std::filesystem::path& path, const std::vector<RayList>& lists);

/// Trusts nothing: sizes are checked against the file's before memory is taken, and rays must be
/// finite (geometry::is_traceable). Throws Error(input_output), which says at which byte.
[[nodiscard]] std::vector<RayList> read_rays(const std::filesystem::path& path);
/// The same from memory; `path` is for messages.
[[nodiscard]] std::vector<RayList> decode_rays(std::span<const std::byte> bytes,
                                               const std::filesystem::path& path);

}  // namespace lume::io
