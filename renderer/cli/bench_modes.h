// SPDX-License-Identifier: Apache-2.0
// What `lume bench` does instead of a race, and what all of that has in common.
#pragma once

#include "renderer/bench/bench.h"
#include "renderer/bench/witness.h"
#include "renderer/cli/bench_options.h"
#include "renderer/cli/exit_codes.h"
#include "renderer/cli/progress.h"
#include "renderer/cli/view.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lume::cli {

/// Renders each scene through every structure, and finds the first ray where pictures differ.
[[nodiscard]] ExitCode run_prove(const BenchOptions& options);
/// Shoots the rays of a file.
[[nodiscard]] ExitCode run_replay(const BenchOptions& options);
/// Draws what the camera's rays cost.
[[nodiscard]] ExitCode run_cost_maps(const BenchOptions& options);

/// The structures that are named, each told whose picture is coming. `rules`: as raced, or exact.
[[nodiscard]] std::vector<renderer::Candidate> name_candidates(
    const std::vector<std::string>& names, const Viewpoint& view,
    const geometry::AcceleratorOptions& rules);

/// The options for one of the scenes; the picture is `width` wide if they do not say.
[[nodiscard]] BenchOptions options_for(const BenchOptions& options, const std::string& scene_file,
                                       int width);

/// A bar on a terminal, nothing in a pipe.
[[nodiscard]] Progress::Style bench_progress_style(const BenchOptions& options);

/// What two structures said of a ray, several lines, every number in hexadecimal as well: decimals
/// round, and a bug on an edge is gone with the last digit.
[[nodiscard]] std::string describe_disagreement(const renderer::Disagreement& found,
                                                const std::string& first, const std::string& second,
                                                const renderer::PreparedScene& prepared);
/// The ray alone.
[[nodiscard]] std::string describe_ray(const geometry::Ray& ray);
/// "instance 0, geometry 1, primitive 7, t = 0x1.8p+1 (3)".
[[nodiscard]] std::string describe_hit(const std::optional<geometry::Hit>& hit,
                                       const geometry::Ray& ray,
                                       const renderer::PreparedScene& prepared);

}  // namespace lume::cli
