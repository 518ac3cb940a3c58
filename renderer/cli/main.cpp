// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/command_line.h"

int main(int argc, char** argv) {
  using lume::cli::ExitCode;
  try {
    return static_cast<int>(lume::cli::run_command_line({argv + 1, argv + argc}));
  } catch (...) {
    return static_cast<int>(lume::cli::report_current_exception());
  }
}
