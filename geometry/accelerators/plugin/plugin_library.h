// SPDX-License-Identifier: Apache-2.0
// A shared library with a structure in it (include/lume/accelerator_plugin.h), and its structures.
// What can be seen to be wrong with either is a std::runtime_error that names the file.
#pragma once

#include "geometry/accelerators/items.h"

#include <lume/accelerator_plugin.h>

#include <memory>
#include <string>
#include <vector>

namespace lume::geometry {

class PluginLibrary {
 public:
  explicit PluginLibrary(const std::string& file);

  [[nodiscard]] const LumeAcceleratorPlugin& table() const { return *table_; }
  /// A complaint about the plugin.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  struct Close {
    void operator()(void* library) const;
  };

  std::string file_;
  std::unique_ptr<void, Close> library_;
  const LumeAcceleratorPlugin* table_ = nullptr;
};

/// The plugin's structure over the triangles of an object.
class PluginStructure {
 public:
  /// Tries the build in another process first, which may crash, or hang over a few triangles,
  /// without harm to this one.
  PluginStructure(const PluginLibrary& library, const TriangleItems& items);
  PluginStructure(const PluginStructure&) = delete;
  PluginStructure& operator=(const PluginStructure&) = delete;
  ~PluginStructure();

  [[nodiscard]] const void* get() const { return structure_; }
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  const PluginLibrary& library_;
  std::vector<float> positions_;
  std::vector<std::uint32_t> corners_;
  void* structure_ = nullptr;
};

}  // namespace lume::geometry
