// SPDX-License-Identifier: Apache-2.0
// What [defaults], [[case]] and [[override]] can all say, and how one of them refines another.
#pragma once

#include "io/image_tests/manifest_table.h"

#include <optional>
#include <string>
#include <vector>

namespace lume::io {

/// What is absent was not said.
struct CaseValues {
  std::optional<Tier> tier;
  std::optional<std::string> reference;  ///< {name} and {stem} are still to be replaced
  std::vector<std::string> render;
  CompareLimits limits;
  std::optional<double> pixels_per_degree;
  std::optional<int> seeds;
  std::optional<double> significance;
  std::optional<double> timeout;
  std::vector<std::string> requires_environment;
  std::optional<std::string> skip;

  /// What `other` says wins; its options of `lume render` come after these, its limits replace
  /// those of the same name, and its variables are wanted as well.
  void refine(const CaseValues& other);
};

/// The keys that read_case_values asks for; `skip` is not for defaults.
[[nodiscard]] std::vector<std::string> case_value_keys(bool with_skip);

[[nodiscard]] CaseValues read_case_values(const std::filesystem::path& file,
                                          const ManifestTable& table);

}  // namespace lume::io
