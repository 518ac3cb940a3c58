// SPDX-License-Identifier: Apache-2.0
// Values on the command line. CLI11's own conversions accept more than they should (hexadecimal,
// trailing text) and complain in its own words, so every value is checked here first.
#pragma once

#include "geometry/math.h"
#include "shading/image.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lume::cli {

/// A whole number in [low, high]. Throws UsageError.
[[nodiscard]] std::uint64_t parse_whole(std::string_view text, std::uint64_t low,
                                        std::uint64_t high);
/// A finite decimal number in [low, high]. Throws UsageError.
[[nodiscard]] double parse_real(std::string_view text, double low, double high);
/// "X,Y,Z", each within [-limit, limit] of a finite limit. Throws UsageError.
[[nodiscard]] geometry::DVec3 parse_triple(std::string_view text, double limit);
/// "WxH+X+Y". Throws UsageError.
[[nodiscard]] shading::PixelRegion parse_crop(std::string_view text);

/// The names between commas. "all" stands for all of them; a name given twice counts once. Throws
/// UsageError for a name that is none of `known`; `what` says what is named.
[[nodiscard]] std::vector<std::string> parse_names(std::string_view text, std::string_view what,
                                                   const std::vector<std::string>& known);

/// The same as checks for CLI11 options.
[[nodiscard]] CLI::Validator whole_between(std::uint64_t low, std::uint64_t high);
[[nodiscard]] CLI::Validator real_between(double low, double high);
/// Anything but nothing and what is plainly the next option ("-o --width 5").
[[nodiscard]] CLI::Validator file_name();
[[nodiscard]] CLI::Validator one_of(std::string what, std::vector<std::string> names);
/// The same, or the name of a file, which has a slash.
[[nodiscard]] CLI::Validator name_or_file(std::string what, std::vector<std::string> names);

}  // namespace lume::cli
