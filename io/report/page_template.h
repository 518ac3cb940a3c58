// SPDX-License-Identifier: Apache-2.0
// The page's own sources, which travel inside the library, and how they are filled in.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lume::io {

/// The text as HTML shows it: markup escaped, control characters left out. A browser replaces what
/// is no UTF-8.
[[nodiscard]] std::string html_text(std::string_view text);

/// page/viewer.html with its style and scripts. Every {{name}} is replaced once by the value of
/// that name, which is taken as it stands; one without a value is left out.
[[nodiscard]] std::string fill_page(
    const std::vector<std::pair<std::string_view, std::string>>& values);

}  // namespace lume::io
