// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace lume::cli {

/// Writes what was asked for to stdout. Throws io::Error(input_output) when it does not take it all
/// (a full disk).
void print_result(const std::string& text);

}  // namespace lume::cli
