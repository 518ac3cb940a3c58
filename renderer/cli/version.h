// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace lume::cli {

struct LibraryVersion {
  std::string name;
  std::string version;
};

/// Of every library in use; of those that can tell, as loaded at run time.
[[nodiscard]] std::vector<LibraryVersion> library_versions();

/// The best of the instruction sets that Embree knows and this machine has: "AVX2".
[[nodiscard]] std::string instruction_set();

/// What `lume --version` prints, several lines.
[[nodiscard]] std::string version_text();

}  // namespace lume::cli
