// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/result_output.h"

#include "io/error.h"

#include <cstdio>

namespace lume::cli {

void print_result(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) {
    throw io::Error(io::ErrorKind::input_output, "standard output", "", "cannot be written");
  }
}

}  // namespace lume::cli
