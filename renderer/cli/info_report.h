// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/gltf/load_gltf.h"

#include <string>

namespace lume::cli {

/// What `lume info` prints for people: aligned, several lines, names made printable.
[[nodiscard]] std::string info_to_text(const io::LoadedScene& loaded, const std::string& file);

/// What `lume info --json` prints; docs/command-line.md describes it. Keys are only ever added.
[[nodiscard]] std::string info_to_json(const io::LoadedScene& loaded, const std::string& file);

}  // namespace lume::cli
