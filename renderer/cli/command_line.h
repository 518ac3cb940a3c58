// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderer/cli/exit_codes.h"

#include <string>
#include <vector>

namespace lume::cli {

/// Does what `lume ARGUMENTS` asks for. Throws UsageError, io::Error and whatever else goes wrong.
[[nodiscard]] ExitCode run_command_line(const std::vector<std::string>& arguments);

/// For use in a catch block: says in one line on stderr what the current exception means, and
/// returns its exit code.
[[nodiscard]] ExitCode report_current_exception();

}  // namespace lume::cli
