// SPDX-License-Identifier: Apache-2.0
#include "io/write_whole_file.h"

#include "io/error.h"

#include <fmt/format.h>

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

namespace lume::io {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw Error(ErrorKind::input_output, path.string(), "", "cannot write: " + reason);
}

/// Hidden, and different for every writer on this machine.
fs::path temporary_beside(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  return path.parent_path() /
         fmt::format(".{}.{}-{}.part", path.filename().string(), ::getpid(), counter++);
}

/// Removes the file it names unless told to keep it.
class Temporary {
 public:
  explicit Temporary(fs::path path) : path_(std::move(path)) {}
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove(path_, ignored);
  }
  [[nodiscard]] const fs::path& path() const { return path_; }
  void keep() { path_.clear(); }

 private:
  fs::path path_;
};

/// 0 or the errno of the first thing that went wrong; a full disk may show on closing only.
int write_bytes(const fs::path& path, std::span<const std::byte> bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wbx");
  if (file == nullptr) return errno;
  int error = 0;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size()) error = errno;
  if (std::fclose(file) != 0 && error == 0) error = errno;
  return error;
}

}  // namespace

void write_whole_file(const fs::path& path, std::span<const std::byte> bytes) {
  std::error_code error;
  const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
  if (error && error != std::errc::no_such_file_or_directory) fail(path, error.message());

  Temporary temporary(temporary_beside(target));
  if (const int code = write_bytes(temporary.path(), bytes); code != 0) {
    fail(path, std::generic_category().message(code));
  }
  fs::rename(temporary.path(), target, error);
  if (error) fail(path, error.message());
  temporary.keep();
}

}  // namespace lume::io
