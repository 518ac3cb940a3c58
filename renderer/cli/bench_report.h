// SPDX-License-Identifier: Apache-2.0
// The result of `lume bench`, and the forms in which it is shown.
#pragma once

#include "renderer/bench/bench.h"
#include "renderer/cli/bench_options.h"
#include "renderer/cli/camera_choice.h"
#include "renderer/cli/machine.h"
#include "renderer/cli/text_table.h"

#include <cstddef>
#include <string>
#include <vector>

namespace lume::cli {

/// One scene's race.
struct SceneBench {
  std::string file;
  std::string camera;  ///< where it comes from; empty if the rays are from a file
  ImageSize size;      ///< of the picture whose rays they are
  std::size_t triangles = 0;
  std::size_t shapes = 0;
  std::size_t instances = 0;
  std::string reference;  ///< whose answers count as right
  renderer::BenchReport report;
};

struct BenchDocument {
  const BenchOptions& options;
  Machine machine;
  std::vector<SceneBench> scenes;
};

/// What every form needs to look up.
[[nodiscard]] const renderer::Timing* find_timing(const renderer::RaySetReport& set,
                                                  std::size_t structure, renderer::RayApi api);
[[nodiscard]] double per_million(std::size_t count, std::size_t of);
/// A structure's name, or the last part of a plugin's path.
[[nodiscard]] std::string short_name(const std::string& structure);
/// The command line that made the document.
[[nodiscard]] std::string bench_command(const BenchOptions& options);
/// "museum.glb: 1,240,000 triangles ...".
[[nodiscard]] std::string describe_scene(const SceneBench& scene);
/// How it was measured, in a sentence or two.
[[nodiscard]] std::string describe_method(const BenchDocument& document);

/// The structures, then a table for each kind of ray.
[[nodiscard]] std::vector<TextTable> bench_tables(const SceneBench& scene,
                                                  const BenchOptions& options);

/// For people.
[[nodiscard]] std::string bench_to_text(const BenchDocument& document);
/// For programs; docs/schema/lume_bench.schema.json describes it. Keys are only ever added.
[[nodiscard]] std::string bench_to_json(const BenchDocument& document);
/// For spreadsheets (RFC 4180): a line for each structure, kind of ray and way of shooting.
[[nodiscard]] std::string bench_to_csv(const BenchDocument& document);
/// One page with plots, that needs nothing else.
[[nodiscard]] std::string bench_to_html(const BenchDocument& document);

}  // namespace lume::cli
