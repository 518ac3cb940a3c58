// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/accelerator.h"

#include "geometry/accelerators/brute_force.h"
#include "geometry/accelerators/embree.h"

#include <array>
#include <stdexcept>
#include <string>

namespace lume::geometry {
namespace {

struct Entry {
  std::string_view name;
  std::unique_ptr<Accelerator> (*make)(const World&, const HoleTest*);
};

constexpr std::array k_entries = {
    Entry{"embree", make_embree},
    Entry{"brute-force", make_brute_force},
};

}  // namespace

AcceleratorStats::AcceleratorStats(const World& world) : instances(world.instances.size()) {
  for (const Object& object : world.objects) {
    for (const Geometry& geometry : object.geometries) primitives += geometry.primitive_count();
  }
}

std::span<const std::string_view> accelerator_names() {
  static constexpr auto k_names = [] {
    std::array<std::string_view, k_entries.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = k_entries[i].name;
    return names;
  }();
  return k_names;
}

std::unique_ptr<Accelerator> make_accelerator(std::string_view name, const World& world,
                                              const HoleTest* holes) {
  for (const Entry& entry : k_entries) {
    if (entry.name == name) return entry.make(world, holes);
  }
  throw std::invalid_argument("unknown accelerator: " + std::string(name));
}

}  // namespace lume::geometry
