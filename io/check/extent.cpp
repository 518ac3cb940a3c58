// SPDX-License-Identifier: Apache-2.0
#include "io/check/rules.h"

#include <fmt/format.h>

#include <algorithm>

namespace lume::io::check {
namespace {

/// A scene beyond these was probably modelled in other units than metres.
constexpr double k_smallest = 0.005;
constexpr double k_largest = 20000.0;

}  // namespace

void check_extent(const Subject& subject, Findings& findings) {
  const shading::Scene& scene = subject.loaded.scene;
  const geometry::Bounds bounds = scene.world.bounds();
  if (scene.world.instances.empty()) {
    findings.add(Severity::warning, "nothing-to-see", "", "the scene shows no surface at all",
                 "look at the other scenes of the file (--scene), or at the findings above");
  } else if (!bounds.is_empty()) {
    const geometry::DVec3 size = geometry::DVec3(bounds.upper) - geometry::DVec3(bounds.lower);
    const double largest = std::max({size.x, size.y, size.z});
    if (largest < k_smallest || largest > k_largest) {
      findings.add(Severity::warning, "scale", "",
                   fmt::format("the scene is {:.3g} m across, and glTF is in metres", largest),
                   "scale its root node (0.01 for centimetres, 0.001 for millimetres): lights, "
                   "absorption and the near plane depend on it");
    }
    if (length(scene.origin) > 100.0 * largest && largest > 0.0) {
      findings.add(Severity::advice, "far-away", "",
                   fmt::format("the scene lies {:.3g} m from the origin", length(scene.origin)),
                   "move it there: other viewers lose precision at such a distance, Lume does not");
    }
  }
}

}  // namespace lume::io::check
