// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/trace_diagram.h"

#include "renderer/cli/text.h"
#include "renderer/cli/trace_terms.h"

#include <fmt/format.h>

#include <utility>

namespace lume::cli {
namespace {

using renderer::RayNote;
using renderer::SurfaceNote;
using renderer::TwigNote;
using shading::Color;

constexpr std::size_t k_shown_lights = 6;

/// Grows the diagram ray by ray.
class Grower {
 public:
  Grower(const TraceReport& report, std::vector<DiagramNode>& nodes)
      : report_(report), tree_(report.tree()), nodes_(nodes) {}

  /// Adds what the ray met, one below the other, and what branched off there.
  void add_ray(std::size_t index, std::size_t parent, const std::string& arrow);

 private:
  [[nodiscard]] DiagramNode describe(const RayNote& ray, const SurfaceNote& surface) const;
  void add_lights(DiagramNode& node, const SurfaceNote& surface) const;
  void add_twig(std::size_t parent, const char* letter, const std::optional<TwigNote>& twig) {
    if (twig) add_ray(twig->ray, parent, fmt::format("{} × {}", letter, short_color(twig->weight)));
  }

  const TraceReport& report_;
  const renderer::RayTree& tree_;
  std::vector<DiagramNode>& nodes_;
};

void Grower::add_ray(std::size_t index, std::size_t parent, const std::string& arrow) {
  const RayNote& ray = tree_.rays[index];
  std::string label = arrow;
  const auto add = [&](DiagramNode node) {
    node.parent = parent;
    node.ray = ray.kind;
    node.arrow = std::exchange(label, "straight on");
    parent = nodes_.size();
    nodes_.push_back(std::move(node));
  };
  for (const SurfaceNote& surface : ray.surfaces) {
    add(describe(ray, surface));
    const std::size_t here = parent;
    add_twig(here, "R", surface.reflection);
    add_twig(here, "T", surface.transmission);
  }
  if (!ray.backdrop && !ray.surfaces.empty()) return;
  DiagramNode end;
  end.kind = ray.backdrop ? DiagramNode::Kind::backdrop : DiagramNode::Kind::nothing;
  end.light = ray.backdrop.value_or(Color(0.0f));
  end.name = ray.backdrop ? "backdrop" : "nothing";
  if (ray.backdrop) end.terms.push_back("I  " + short_color(end.light));
  add(std::move(end));
}

DiagramNode Grower::describe(const RayNote& ray, const SurfaceNote& surface) const {
  const geometry::Hit& hit = surface.point.hit;
  const renderer::LightTerms& terms = surface.terms;
  DiagramNode node;
  node.light = surface.scale * terms.sum();
  node.name = printable(object_name(report_.scene, hit));
  node.material = printable(material_name(report_.scene, hit)) + (surface.inside ? ", inside" : "");
  node.terms.push_back("I  " + short_color(terms.sum()));
  const auto add = [&](const char* name, const Color& term) {
    if (term != Color(0.0f)) node.terms.push_back(fmt::format("{} {}", name, short_color(term)));
  };
  add("emitted", terms.emitted);
  add("ambient", terms.ambient);
  add("diffuse", terms.diffuse);
  add("specular", terms.specular);
  add("reflected", terms.reflected);
  add("transmitted", terms.transmitted);
  if (surface.scale != Color(1.0f)) node.terms.push_back("counts × " + short_color(surface.scale));
  node.terms.push_back(fmt::format("t  {:.4g} m", distance_to(ray, surface)));
  add_lights(node, surface);
  return node;
}

void Grower::add_lights(DiagramNode& node, const SurfaceNote& surface) const {
  for (std::size_t i = 0; i < surface.light_count; ++i) {
    if (i == k_shown_lights) {
      node.terms.push_back(fmt::format("and {} more lights", surface.light_count - i));
      break;
    }
    const renderer::LightNote& light = tree_.lights[surface.first_light + i];
    node.lights.push_back({&light, printable(light_name(report_.scene, light))});
  }
}

}  // namespace

std::vector<DiagramNode> make_diagram(const TraceReport& report) {
  std::vector<DiagramNode> nodes(1);
  DiagramNode& eye = nodes.front();
  eye.kind = DiagramNode::Kind::eye;
  eye.light = report.trace.sums[report.options.sample].color();
  eye.name = "eye";
  eye.terms = {"I  " + short_color(eye.light)};
  Grower(report, nodes).add_ray(0, 0, "E");
  return nodes;
}

std::string short_color(const Color& color) {
  if (color.x == color.y && color.y == color.z) return fmt::format("{:.3g}", color.x + 0.0f);
  return fmt::format("{:.3g} {:.3g} {:.3g}", color.x + 0.0f, color.y + 0.0f, color.z + 0.0f);
}

}  // namespace lume::cli
