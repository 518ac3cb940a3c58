// SPDX-License-Identifier: Apache-2.0
// What `lume check` found, for people and for programs.
#pragma once

#include "io/check/check_scene.h"

#include <string>
#include <vector>

namespace lume::cli {

[[nodiscard]] std::string check_to_text(const std::vector<io::check::Finding>& findings,
                                        const std::string& file);
/// docs/command-line.md describes the members.
[[nodiscard]] std::string check_to_json(const std::vector<io::check::Finding>& findings,
                                        const std::string& file);

}  // namespace lume::cli
