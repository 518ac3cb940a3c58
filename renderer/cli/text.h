// SPDX-License-Identifier: Apache-2.0
// Numbers and names the way people like to read them.
#pragma once

#include "geometry/math.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lume::cli {

/// The text on one line and without control characters: names come from files, and a terminal obeys
/// escape sequences.
[[nodiscard]] std::string printable(std::string_view text);

/// "a, b, c", cut off after the first dozen.
[[nodiscard]] std::string list_names(const std::vector<std::string>& names);

/// "1,234,567".
[[nodiscard]] std::string format_count(std::uint64_t count);
/// "512 B", "1.5 KiB", "2.0 GiB".
[[nodiscard]] std::string format_bytes(std::uint64_t bytes);
/// "0.25 s", "12 s", "3 min 05 s", "2 h 01 min".
[[nodiscard]] std::string format_duration(double seconds);
/// "(1, 2.5, -3)" with six significant digits.
[[nodiscard]] std::string format_vector(const geometry::DVec3& v);

/// The text as one word of a POSIX shell.
[[nodiscard]] std::string shell_quote(std::string_view text);

}  // namespace lume::cli
