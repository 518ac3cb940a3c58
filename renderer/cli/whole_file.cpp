// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/whole_file.h"

#include "io/error.h"
#include "io/write_whole_file.h"
#include "renderer/cli/text.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <span>
#include <sstream>
#include <system_error>

namespace lume::cli {
namespace {

constexpr std::streamoff k_tail_bytes = 16384;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw io::Error(io::ErrorKind::input_output, path.string(), "", reason);
}

}  // namespace

void copy_whole(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::ifstream stream(from, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) fail(from, "cannot be read");
  io::write_whole_file(to, std::as_bytes(std::span(bytes)));
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder)) {
    fail(folder, "cannot be made a folder" + (error ? ": " + error.message() : ""));
  }
}

std::vector<std::string> last_lines(const std::filesystem::path& file, std::size_t most) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream.tellg();
  stream.seekg(std::max<std::streamoff>(0, size - k_tail_bytes));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(printable(line));
  if (lines.size() > most) lines.erase(lines.begin(), lines.end() - static_cast<long>(most));
  return lines;
}

}  // namespace lume::cli
