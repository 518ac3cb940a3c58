// SPDX-License-Identifier: Apache-2.0
// What somebody probably meant who mistyped a name.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lume::io {

/// Lower case with '-' and '_' read as spaces: the form in which names typed by people are
/// compared.
[[nodiscard]] std::string relaxed_name(std::string_view name);

/// How many letters must be put in, left out, replaced or swapped with their neighbour to turn `a`
/// into `b` (optimal string alignment distance).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known name that is nearest by relaxed_name(): the first that holds the wrong one, or that
/// takes the fewest edits to reach; empty if each takes more than a third of the letters.
[[nodiscard]] std::string nearest_name(std::string_view wrong,
                                       const std::vector<std::string>& known);

/// The end of a message about an unknown name: "; did you mean a? There are: a, b, c".
[[nodiscard]] std::string list_names(std::string_view wrong, const std::vector<std::string>& known);

}  // namespace lume::io
