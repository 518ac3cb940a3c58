// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/suggest.h"

#include "io/nearest_name.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>

namespace lume::cli {

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
  const std::string nearest = io::nearest_name(word, names);
  return nearest.empty() ? "" : fmt::format("; did you mean '{}'?", printable(nearest));
}

std::string unknown_name(std::string_view what, std::string_view word,
                         const std::vector<std::string>& names) {
  const std::string nearest = io::nearest_name(word, names);
  const std::string hint =
      nearest.empty() ? "" : fmt::format("did you mean '{}'? ", printable(nearest));
  const std::string list =
      names.empty() ? "there is none" : fmt::format("known: {}", list_names(names));
  return fmt::format("unknown {} '{}'; {}({})", what, printable(word), hint, list);
}

std::vector<std::string> to_strings(std::span<const std::string_view> names) {
  return {names.begin(), names.end()};
}

}  // namespace lume::cli
