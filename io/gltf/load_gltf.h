// SPDX-License-Identifier: Apache-2.0
// From a .gltf or .glb file to a Scene. Every byte of the file is checked before it is believed.
#pragma once

#include "shading/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lume::io {

/// How much of a glTF extension Lume honours.
enum class Support { full, partial, ignored };

struct ExtensionUse {
  std::string name;
  Support support = Support::ignored;
  std::string remark;  ///< what is left out; empty when support is full
  bool required = false;
};

/// A Scene and what a reader wants to know of the file beside it.
struct LoadedScene {
  shading::Scene scene;
  std::vector<std::string> scene_names;  ///< every scene of the file (a name, or "scene N")
  std::size_t scene_index = 0;           ///< the one that was loaded
  std::vector<ExtensionUse> extensions;  ///< extensionsUsed and extensionsRequired
  std::string generator;                 ///< asset.generator
  std::string copyright;                 ///< asset.copyright
  /// Things left out or repaired, one line each ("mesh 3 primitive 0: lines are skipped").
  std::vector<std::string> notes;
};

struct LoadOptions {
  std::optional<std::string> scene = std::nullopt;  ///< name or number; absent: the file's default
  /// Seconds into the animation; absent: nodes stay where they were modelled.
  std::optional<double> time = std::nullopt;
  /// Name or number; absent: the first. Without a time it has no effect.
  std::optional<std::string> animation = std::nullopt;
  /// Mesh primitives that are bound to analytic shapes are drawn as their triangles, and shapes
  /// that nodes are bound to are left out.
  bool tessellated = false;
  bool decode_images = true;  ///< off: images have their size but no texels (for `lume info`)
};

/// Throws Error (scene: what is wrong in the content, with its JSON pointer; input_output: a file
/// cannot be read).
[[nodiscard]] LoadedScene load_gltf(const std::filesystem::path& path,
                                    const LoadOptions& options = {});

}  // namespace lume::io
