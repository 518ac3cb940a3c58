// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/replay.h"

#include "renderer/cli/text.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace lume::cli {
namespace {

enum class Part { keep, drop, drop_with_value };

Part part_of(std::string_view argument) {
  constexpr std::array<std::string_view, 4> k_dropped = {"--output", "--crop", "--stats", "--aov"};
  if (argument == "-o") return Part::drop_with_value;
  if (argument.starts_with("-o")) return Part::drop;  // -oFILE
  for (const std::string_view name : k_dropped) {
    if (argument == name) return Part::drop_with_value;
    if (argument.starts_with(std::string(name) + "=")) return Part::drop;
  }
  return Part::keep;
}

}  // namespace

std::string replay_command(const std::vector<std::string>& arguments, int x, int y) {
  std::string command = "lume render";
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const Part part = part_of(arguments[i]);
    if (part == Part::drop_with_value) ++i;
    if (part == Part::keep) command += " " + shell_quote(printable(arguments[i]));
  }
  return command + fmt::format(" --crop 1x1+{}+{} -o replay.exr", x, y);
}

}  // namespace lume::cli
