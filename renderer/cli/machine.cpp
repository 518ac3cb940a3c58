// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/machine.h"

#include "geometry/accelerators/embree.h"
#include "lume_version.h"
#include "renderer/cli/text.h"
#include "renderer/cli/version.h"

#include <fmt/format.h>

#include <fstream>
#include <string_view>
#include <thread>

namespace lume::cli {
namespace {

#ifdef __clang__
constexpr std::string_view k_compiler = "clang++ " __clang_version__;
#else
constexpr std::string_view k_compiler = "g++ " __VERSION__;
#endif

// The levels of the x86-64 psABI, as far as the compiler's own words tell them apart.
#if defined(__AVX512F__) && defined(__AVX512VL__)
constexpr std::string_view k_compiled_for = "x86-64-v4";
#elif defined(__AVX2__)
constexpr std::string_view k_compiled_for = "x86-64-v3";
#else
constexpr std::string_view k_compiled_for = "x86-64-v2";
#endif

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      return printable(line.substr(colon + 2));
    }
  }
  return "unknown processor";
}

}  // namespace

Machine this_machine() {
  std::string compiler(k_compiler);
  compiler.erase(compiler.find_last_not_of(' ') + 1);  // clang's ends on a space
  return {cpu_model(),
          std::thread::hardware_concurrency(),
          instruction_set(),
          compiler,
          std::string(k_compiled_for),
          std::string(k_version),
          geometry::embree_version()};
}

std::string describe(const Machine& machine) {
  return fmt::format("{}, {} core{}, {}; Lume {} by {} for {}; Embree {}", machine.cpu,
                     machine.cores, machine.cores == 1 ? "" : "s", machine.instruction_set,
                     machine.lume, machine.compiler, machine.compiled_for, machine.embree);
}

}  // namespace lume::cli
