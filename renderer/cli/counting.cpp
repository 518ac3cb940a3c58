// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/counting.h"

#include "renderer/cli/exit_codes.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>

namespace lume::cli {

std::vector<std::string> counting_accelerators() {
  // Each is asked, over a world of one triangle.
  geometry::Mesh mesh;
  mesh.positions = {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
  mesh.triangles = {{0, 1, 2}};
  geometry::World world;
  world.objects.emplace_back().geometries.push_back({mesh});
  world.instances.emplace_back();
  std::vector<std::string> names;
  for (const std::string_view name : geometry::accelerator_names()) {
    if (make_accelerator(name, world, nullptr)->counts_cost()) names.emplace_back(name);
  }
  return names;
}

void check_counts_cost(const std::string& option, const std::string& name,
                       const geometry::Accelerator& accelerator) {
  if (accelerator.counts_cost()) return;
  throw UsageError(fmt::format("{}: {} does not count what a ray costs; choose one of {}", option,
                               printable(name), list_names(counting_accelerators())));
}

}  // namespace lume::cli
