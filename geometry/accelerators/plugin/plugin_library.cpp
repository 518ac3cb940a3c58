// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/plugin/plugin_library.h"

#include <dlfcn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

namespace lume::geometry {
namespace {

constexpr unsigned k_most_seconds = 5;  // for a few triangles
constexpr std::uint32_t k_few = 64;     // triangles
constexpr int k_refused = 1;            // exit code of the trial

LumeTriangles triangles_of(const std::vector<float>& positions,
                           const std::vector<std::uint32_t>& corners, std::uint32_t most) {
  const auto count = static_cast<std::uint32_t>(corners.size() / 3);
  return {positions.data(), static_cast<std::uint32_t>(positions.size() / 3), corners.data(),
          count < most ? count : most};
}

/// What a child process does: builds and asks, and says by its exit code how that went.
[[noreturn]] void try_out(const LumeAcceleratorPlugin& plugin, const LumeTriangles& triangles,
                          unsigned seconds) {
  alarm(seconds);
  std::array<char, 256> message{};
  void* structure = plugin.build(&triangles, message.data(), message.size());
  if (structure == nullptr) _exit(k_refused);
  const float* p = triangles.positions;
  const LumeRay ray{{p[0], p[1], p[2] + 1.0f}, 0.0f, {0.1f, 0.2f, -1.0f}, 1e30f};
  LumeHit hit{};
  plugin.closest_hit(structure, &ray, &hit);
  plugin.any_hit(structure, &ray);
  plugin.destroy(structure);
  _exit(0);
}

/// Whether a trial in another process goes well; a refusal is left to the build itself.
void try_elsewhere(const PluginLibrary& library, const LumeTriangles& triangles, unsigned seconds) {
  const pid_t child = fork();
  if (child == 0) try_out(library.table(), triangles, seconds);
  if (child < 0) return;  // no room for a trial: go on without
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
  }
  const std::string what = "over " + std::to_string(triangles.triangle_count) + " triangles";
  if (!WIFSIGNALED(status)) return;
  if (WTERMSIG(status) == SIGALRM) {
    library.fail("did not build " + what + " in " + std::to_string(seconds) + " seconds");
  }
  library.fail("crashed (signal " + std::to_string(WTERMSIG(status)) + ") when it was tried " +
               what);
}

}  // namespace

void PluginLibrary::Close::operator()(void* library) const { dlclose(library); }

PluginLibrary::PluginLibrary(const std::string& file)
    : file_(file), library_(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (library_ == nullptr) {
    const char* const why = dlerror();
    fail(std::string("cannot be loaded: ") + (why != nullptr ? why : "no reason given"));
  }
  constexpr const char* k_entry = "lume_accelerator_plugin";
  void* const symbol = dlsym(library_.get(), k_entry);
  if (symbol == nullptr) {
    fail(std::string("is no accelerator plugin: it does not export ") + k_entry + "()");
  }
  table_ = reinterpret_cast<decltype(&lume_accelerator_plugin)>(symbol)();
  if (table_ == nullptr) fail(std::string(k_entry) + "() returns nothing");
  if (table_->version != LUME_ACCELERATOR_PLUGIN_VERSION) {
    fail("is made for version " + std::to_string(table_->version) +
         " of the plugin interface; this Lume has version " +
         std::to_string(LUME_ACCELERATOR_PLUGIN_VERSION));
  }
  const bool complete = table_->build != nullptr && table_->closest_hit != nullptr &&
                        table_->any_hit != nullptr && table_->destroy != nullptr;
  if (!complete) fail("has no build, closest_hit, any_hit or destroy");
}

void PluginLibrary::fail(const std::string& what) const {
  throw std::runtime_error(file_ + ": " + what);
}

PluginStructure::PluginStructure(const PluginLibrary& library, const TriangleItems& items)
    : library_(library) {
  if (items.size() == 0) return;
  positions_.reserve(9 * std::size_t{items.size()});
  corners_.reserve(3 * std::size_t{items.size()});
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    const auto corners = items.corners(i);
    for (const Vec3& corner : corners) {
      corners_.push_back(static_cast<std::uint32_t>(corners_.size()));
      positions_.insert(positions_.end(), {corner.x, corner.y, corner.z});
    }
  }
  const LumeTriangles triangles = triangles_of(positions_, corners_, items.size());
  try_elsewhere(library, triangles_of(positions_, corners_, k_few), k_most_seconds);
  constexpr unsigned k_no_limit = 0;
  if (items.size() > k_few) try_elsewhere(library, triangles, k_no_limit);
  std::array<char, 256> message{};
  structure_ = library.table().build(&triangles, message.data(), message.size());
  message.back() = '\0';
  if (structure_ == nullptr) {
    library.fail("refuses to build over " + std::to_string(items.size()) +
                 " triangles: " + message.data());
  }
}

PluginStructure::~PluginStructure() {
  if (structure_ != nullptr) library_.table().destroy(structure_);
}

std::size_t PluginStructure::memory_bytes() const {
  const auto ask = library_.table().memory_bytes;
  return structure_ != nullptr && ask != nullptr ? ask(structure_) : 0;
}

}  // namespace lume::geometry
