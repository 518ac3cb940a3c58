// SPDX-License-Identifier: Apache-2.0
// "Did you mean ...?" for options, subcommands and names that were mistyped.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lume::cli {

/// "; did you mean 'NAME'?", or nothing when no name is near.
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       const std::vector<std::string>& names);

/// The complaint about a name that is none of `names`: the nearest, and a list of what there is.
/// `what` says what was named ("integrator", "camera").
[[nodiscard]] std::string unknown_name(std::string_view what, std::string_view word,
                                       const std::vector<std::string>& names);

[[nodiscard]] std::vector<std::string> to_strings(std::span<const std::string_view> names);

}  // namespace lume::cli
