// SPDX-License-Identifier: Apache-2.0
// The subcommands of `lume`. Each one has its options, and a function to run once they are parsed.
#pragma once

#include "renderer/cli/exit_codes.h"

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;  // its header costs seconds a file
}

namespace lume::cli {

struct Command {
  CLI::App* app = nullptr;
  std::function<ExitCode()> run;
};

/// `arguments` is the command line after `lume render`, which a message may quote.
[[nodiscard]] Command add_render_command(CLI::App& parent, std::vector<std::string> arguments);
[[nodiscard]] Command add_trace_command(CLI::App& parent);
/// `arguments` is the command line after `lume bench`, which reports quote.
[[nodiscard]] Command add_bench_command(CLI::App& parent, std::vector<std::string> arguments);
/// `arguments` is the command line after `lume compare`, which the page quotes.
[[nodiscard]] Command add_compare_command(CLI::App& parent, std::vector<std::string> arguments);
/// `arguments` is the command line after `lume test`, which reports quote.
[[nodiscard]] Command add_test_command(CLI::App& parent, std::vector<std::string> arguments);
[[nodiscard]] Command add_info_command(CLI::App& parent);
[[nodiscard]] Command add_check_command(CLI::App& parent);

}  // namespace lume::cli
