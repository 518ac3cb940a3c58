// SPDX-License-Identifier: Apache-2.0
// What a manifest's texts are made of: words, ${VARIABLES}, {placeholders} and globs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lume::io {

/// The words of a text as a shell would take them, with '...' and "..." around what has spaces and
/// nothing else that is special. Throws std::invalid_argument for a quote that does not end.
[[nodiscard]] std::vector<std::string> split_words(std::string_view text);

/// Replaces {key} for each of the keys; other braces stay.
[[nodiscard]] std::string fill_placeholders(
    std::string text, const std::vector<std::pair<std::string, std::string>>& values);

/// Names of the variables in ${NAME}. Throws std::invalid_argument for one that does not end.
[[nodiscard]] std::vector<std::string> environment_names(std::string_view text);
/// Replaces ${NAME} by the environment's value, or by nothing where it has none.
[[nodiscard]] std::string fill_environment(std::string_view text);
/// Whether the environment has the variable, and in it something.
[[nodiscard]] bool has_environment(const std::string& name);

/// Whether the text stands for files by *, ?, [...] or {a,b}.
[[nodiscard]] bool is_glob(std::string_view text);
/// The files in the folder that the pattern stands for (glob(7), and {a,b}), sorted by bytes. A
/// pattern may also be an absolute one.
[[nodiscard]] std::vector<std::filesystem::path> glob_files(const std::filesystem::path& folder,
                                                            const std::string& pattern);
/// Whether all of the name is what the pattern (glob(7)) stands for.
[[nodiscard]] bool glob_matches(const std::string& pattern, const std::string& name);

}  // namespace lume::io
