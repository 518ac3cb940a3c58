// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/accelerator.h"

#include "geometry/accelerators/plugin/plugin.h"
#include "geometry/accelerators/registry.h"

#include <array>
#include <stdexcept>
#include <string>

namespace lume::geometry {

AcceleratorStats::AcceleratorStats(const World& world) : instances(world.instances.size()) {
  for (const Object& object : world.objects) {
    for (const Geometry& geometry : object.geometries) primitives += geometry.primitive_count();
  }
}

void Accelerator::closest_hits(std::span<const Ray> rays,
                               std::span<std::optional<Hit>> hits) const {
  for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = closest_hit(rays[i]);
}

void Accelerator::any_hits(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const {
  for (std::size_t i = 0; i < rays.size(); ++i) occluded[i] = any_hit(rays[i]) ? 1 : 0;
}

std::optional<Hit> Accelerator::closest_hit_counted(const Ray& ray, TraversalCost& /*cost*/) const {
  return closest_hit(ray);
}

bool Accelerator::any_hit_counted(const Ray& ray, TraversalCost& /*cost*/) const {
  return any_hit(ray);
}

void Accelerator::prepare_view(const Camera& /*camera*/, int /*width*/, int /*height*/) {}

std::span<const std::string_view> accelerator_names() {
  static constexpr auto k_names = [] {
    std::array<std::string_view, k_registry.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = k_registry[i].name;
    return names;
  }();
  return k_names;
}

std::unique_ptr<Accelerator> make_accelerator(std::string_view name, const World& world,
                                              const HoleTest* holes,
                                              const AcceleratorOptions& options) {
  if (name.find('/') != std::string_view::npos) return make_plugin(std::string(name), world, holes);
  for (const AcceleratorEntry& entry : k_registry) {
    if (entry.name == name) return entry.make(world, holes, options);
  }
  throw std::invalid_argument("unknown accelerator: " + std::string(name));
}

}  // namespace lume::geometry
