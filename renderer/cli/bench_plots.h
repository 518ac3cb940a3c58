// SPDX-License-Identifier: Apache-2.0
// Plots of a race, as <svg> elements for a page.
#pragma once

#include "renderer/cli/bench_report.h"

#include <string>

namespace lume::cli {

/// Bars of the ratio to the baseline with their intervals, a panel for each kind of ray.
[[nodiscard]] std::string plot_ratios(const SceneBench& scene);
/// A point for each structure: build time on one thread across (logarithmic), rays a second (the
/// geometric mean over the kinds) up.
[[nodiscard]] std::string plot_build_against_rays(const SceneBench& scene);
/// Bars of bytes a primitive.
[[nodiscard]] std::string plot_memory(const SceneBench& scene);

}  // namespace lume::cli
