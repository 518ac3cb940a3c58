// SPDX-License-Identifier: Apache-2.0
// The ray tree as a diagram: nodes with their texts, before anything is drawn.
#pragma once

#include "renderer/cli/trace_layout.h"
#include "renderer/cli/trace_report.h"

#include <string>
#include <vector>

namespace lume::cli {

/// A shadow ray, beside the surface that it left.
struct DiagramLight {
  const renderer::LightNote* note = nullptr;
  std::string label;
};

struct DiagramNode {
  enum class Kind { eye, surface, backdrop, nothing };

  Kind kind = Kind::surface;
  std::size_t parent = 0;  ///< stands before its children; the eye, number 0, is its own
  renderer::RayKind ray = renderer::RayKind::camera;  ///< the ray that arrives here
  std::string arrow;                                  ///< the label of that ray
  shading::Color light{0.0f};                         ///< what goes back along it (nits)
  std::string name;                                   ///< of the object
  std::string material;
  std::vector<std::string> terms;
  std::vector<DiagramLight> lights;
};

/// The eye first. Texts are printable, but not yet escaped for any format.
[[nodiscard]] std::vector<DiagramNode> make_diagram(const TraceReport& report);

/// "0.25 0.5 1", or one number for grey, with three digits.
[[nodiscard]] std::string short_color(const shading::Color& color);

}  // namespace lume::cli
