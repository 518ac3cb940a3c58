// SPDX-License-Identifier: Apache-2.0
// Which cases of a manifest are run, and everything that can be known to be wrong before.
#pragma once

#include "io/image_tests/manifest.h"
#include "renderer/cli/render_options.h"
#include "renderer/cli/test_options.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lume::cli {

/// A case that is ready to be run.
struct PlannedCase {
  io::TestCase test;
  RenderOptions render;          ///< of a scene; without outputs
  std::filesystem::path folder;  ///< where its pictures go
  std::string accept_command;    ///< that would make its image the reference
  std::filesystem::path start;   ///< where its command runs

  [[nodiscard]] bool is_render() const { return !test.scene.empty(); }
  /// folder/name with the reference's extension.
  [[nodiscard]] std::filesystem::path picture(const std::string& name) const {
    return folder / (name + test.reference.extension().string());
  }
};

/// The cases that the options ask for, in the manifest's order. The options of `lume render` are
/// read for all cases. Throws io::ManifestError, and UsageError for a filter that chooses nothing.
[[nodiscard]] std::vector<PlannedCase> plan_tests(const io::Manifest& manifest,
                                                  const TestOptions& options);

/// Whether the case is in the part. It depends on nothing but the name.
[[nodiscard]] bool is_in_shard(const std::string& name, const Shard& shard);

/// Those of `names` that one of the filters chooses: the one that has its very name, or else each
/// that it matches as a glob or is in the name of.
[[nodiscard]] std::vector<bool> choose_names(const std::vector<std::string>& names,
                                             const std::vector<std::string>& filters);

}  // namespace lume::cli
