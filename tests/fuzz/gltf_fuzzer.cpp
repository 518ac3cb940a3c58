// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes are, loading them gives a scene or an io::Error: scripts/fuzz runs this.
#include "io/check/check_scene.h"
#include "io/error.h"
#include "io/gltf/load_gltf.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace {

/// A file in memory with a name that can be opened. Its folder holds no other files, so that URIs
/// lead nowhere.
class MemoryFile {
 public:
  MemoryFile(const std::uint8_t* data, std::size_t size) : descriptor_(memfd_create("fuzz", 0)) {
    if (descriptor_ < 0 || write(descriptor_, data, size) != static_cast<ssize_t>(size)) abort();
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(descriptor_); }

  [[nodiscard]] std::filesystem::path path() const {
    return "/proc/self/fd/" + std::to_string(descriptor_);
  }

 private:
  int descriptor_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(data, size);
  try {
    static_cast<void>(lume::io::load_gltf(file.path()));
    // What loads, the checker must be able to look over.
    static_cast<void>(lume::io::check::check_scene(file.path()));
  } catch (const lume::io::Error&) {  // the one answer to bad input
    return 0;
  }
  return 0;
}
