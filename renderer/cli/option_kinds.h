// SPDX-License-Identifier: Apache-2.0
// Kinds of options that CLI11 has not got.
#pragma once

#include "renderer/cli/argument_parsing.h"
#include "renderer/cli/exit_codes.h"
#include "renderer/cli/suggest.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace lume::cli {

/// An option whose text `parse` turns into the value. Its complaints get the option's name.
template <class T, class Parse>
CLI::Option* add_parsed(CLI::App& app, const std::string& name, T& value, Parse parse,
                        const std::string& help) {
  const std::function<void(const std::string&)> store = [name, &value,
                                                         parse](const std::string& text) {
    try {
      value = parse(text);
    } catch (const UsageError& error) {
      throw UsageError(fmt::format("{}: {}", name, error.what()));
    }
  };
  return app.add_option_function(name, store, help);
}

/// An option with one of a few names; the first one is the default.
inline void add_choice(CLI::App& app, const std::string& option, std::string& value,
                       const std::string& what, const std::vector<std::string>& names,
                       const std::string& group) {
  if (value.empty()) value = names.front();
  app.add_option(option, value, fmt::format("{} ({})", list_names(names), value))
      ->check(one_of(what, names))
      ->type_name("NAME")
      ->group(group);
}

}  // namespace lume::cli
