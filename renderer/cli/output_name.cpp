// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/output_name.h"

#include <fmt/format.h>

namespace lume::cli {

std::filesystem::path frame_path(const std::filesystem::path& name, int frame) {
  std::string file = name.filename().string();
  const std::size_t last = file.find_last_of('#');
  if (last == std::string::npos) return name;
  const std::size_t before = file.find_last_not_of('#', last);
  const std::size_t first = before == std::string::npos ? 0 : before + 1;
  const std::size_t digits = last + 1 - first;
  file.replace(first, digits, fmt::format("{:0{}}", frame, digits));
  return name.parent_path() / file;
}

}  // namespace lume::cli
