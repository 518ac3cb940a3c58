// SPDX-License-Identifier: Apache-2.0
// Which glTF extensions Lume honours, and how far.
#pragma once

#include "io/gltf/json_view.h"
#include "io/gltf/load_gltf.h"
#include "io/gltf/notes.h"

#include <span>
#include <string_view>
#include <vector>

namespace lume::io::gltf {

struct KnownExtension {
  std::string_view name;
  Support support;
  std::string_view remark;  ///< what is left out; empty when support is full
  bool is_vital = false;    ///< a file that requires it cannot be drawn without it
};

/// All that Lume has heard of, sorted by name.
[[nodiscard]] std::span<const KnownExtension> known_extensions();

/// Throws Error(scene) for an entry of extensionsRequired without which the file cannot be drawn.
void check_required_extension(const JsonView& name);

/// extensionsUsed and extensionsRequired; what is ignored or unknown is noted.
[[nodiscard]] std::vector<ExtensionUse> list_extensions(const JsonView& root, Notes& notes);

}  // namespace lume::io::gltf
