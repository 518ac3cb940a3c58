// SPDX-License-Identifier: Apache-2.0
// A traced pixel, and the forms in which `lume trace` shows it.
#pragma once

#include "io/gltf/write_lines.h"
#include "renderer/cli/camera_choice.h"
#include "renderer/cli/trace_options.h"
#include "renderer/pixel.h"
#include "shading/scene.h"

#include <string>
#include <vector>

namespace lume::cli {

struct TraceReport {
  const TraceOptions& options;
  const shading::Scene& scene;
  ImageSize size;
  std::string camera;  ///< where it comes from
  std::string light;   ///< what lights the scene
  renderer::PixelTrace trace;

  /// The tree to be shown.
  [[nodiscard]] const renderer::RayTree& tree() const { return trace.samples[options.sample]; }
};

/// True if the terms of every sample, added up anew, are what the integrator found, and their mean
/// is the pixel, to the last bit.
[[nodiscard]] bool adds_up(const renderer::PixelTrace& trace);

/// For people: the tree, drawn with characters, and every term.
[[nodiscard]] std::string trace_to_text(const TraceReport& report);
/// For programs: all samples; docs/trace.md describes it. Keys are only ever added.
[[nodiscard]] std::string trace_to_json(const TraceReport& report);
/// The tree as a drawing.
[[nodiscard]] std::string trace_to_svg(const TraceReport& report);
/// Its rays as lines in the scene's frame, a group for each kind, in the order of RayLook.
[[nodiscard]] std::vector<io::LineGroup> trace_to_lines(const TraceReport& report);

}  // namespace lume::cli
