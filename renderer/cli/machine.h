// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace lume::cli {

/// On what, and by what, something was measured.
struct Machine {
  std::string cpu;  ///< "Intel(R) Xeon(R) Processor"
  unsigned cores = 0;
  std::string instruction_set;  ///< that Embree and code that chooses at run time may use
  std::string compiler;         ///< "g++ 12.2.0"
  std::string compiled_for;     ///< what the rest of Lume may use: "x86-64-v2"
  std::string lume;
  std::string embree;
};

[[nodiscard]] Machine this_machine();

/// One line.
[[nodiscard]] std::string describe(const Machine& machine);

}  // namespace lume::cli
