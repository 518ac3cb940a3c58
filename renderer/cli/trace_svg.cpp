// SPDX-License-Identifier: Apache-2.0
// Draws the ray tree the way the course does: the eye on top, a circle for each surface, arrows R
// and T for the rays that leave it, dashed lines to the lights.
#include "renderer/cli/svg_writer.h"
#include "renderer/cli/text.h"
#include "renderer/cli/trace_diagram.h"
#include "renderer/cli/trace_terms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lume::cli {
namespace {

using shading::Color;
using Kind = DiagramNode::Kind;

constexpr double k_radius = 14.0;  // of a surface
constexpr double k_light_radius = 6.0;
constexpr double k_light_x = -52.0;  // of a light, from the surface's axis
constexpr double k_light_row = 26.0;
constexpr double k_text_x = k_radius + 8.0;
constexpr double k_line = 11.0;
constexpr double k_margin = 24.0;
constexpr double k_header = 128.0;
constexpr double k_least_width = 860.0;
constexpr std::size_t k_longest_name = 26;
constexpr std::size_t k_longest_light = 14;

std::string hex(const std::array<std::uint8_t, 3>& c) {
  return fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]);
}

/// IEC 61966-2-1, of what is within the display's range.
std::string display_color(const Color& light) {
  std::array<std::uint8_t, 3> srgb{};
  for (int i = 0; i < 3; ++i) {
    const float c = light[i] > 0.0f ? std::min(light[i], 1.0f) : 0.0f;  // NaN: black
    const float encoded = c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1.0f / 2.4f) - 0.055f;
    srgb[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(255.0f * encoded));
  }
  return hex(srgb);
}

/// About as wide as the text is in most fonts.
double text_width(std::string_view text, double font_size) {
  return 0.62 * font_size * static_cast<double>(count_characters(text));
}

TreeBox box_of(const DiagramNode& node) {
  TreeBox box{k_radius, k_radius, 2.0 * k_radius, node.parent};
  double text = text_width(shorten(node.name, k_longest_name), 11.0);
  text = std::max(text, text_width(shorten(node.material, k_longest_name), 9.0));
  for (const std::string& term : node.terms) text = std::max(text, text_width(term, 8.0));
  const double arrow = text_width(node.arrow, 9.0) + 8.0;
  box.left = std::max(box.left, arrow);
  box.right = std::max(k_text_x + text, arrow);
  const auto lines = static_cast<double>(node.terms.size() + (node.material.empty() ? 1 : 2));
  box.height = std::max(box.height, lines * k_line + 4.0);
  for (const DiagramLight& light : node.lights) {
    const double label = text_width(shorten(light.label, k_longest_light), 8.0);
    box.left = std::max(box.left, -k_light_x + k_light_radius + 8.0 + label);
  }
  const double lights = static_cast<double>(node.lights.size()) * k_light_row;
  box.height = std::max(box.height, lights + k_radius - k_light_row / 2.0);
  return box;
}

void draw_light(SvgWriter& svg, const DiagramLight& light, const SvgPoint& surface,
                const SvgPoint& center) {
  const bool blocked = is_blocked(*light.note);
  const std::string color = hex(look_of(*light.note).srgb);
  svg.line({surface.x - k_radius, surface.y}, {center.x + k_light_radius + 4.0, center.y},
           fmt::format(R"(stroke="{}" stroke-dasharray="4 3")", color));
  for (int i = 0; i < 8; ++i) {
    const double angle = M_PI * i / 4.0;
    const SvgPoint along{std::cos(angle), std::sin(angle)};
    const double far = k_light_radius + 4.0;
    svg.line({center.x + k_light_radius * along.x, center.y + k_light_radius * along.y},
             {center.x + far * along.x, center.y + far * along.y},
             fmt::format(R"(stroke="{}")", color));
  }
  const std::string fill = blocked ? "#ddd" : display_color(light.note->light);
  svg.circle(center, k_light_radius, fmt::format(R"(fill="{}" stroke="{}")", fill, color));
  const double r = k_light_radius + 3.0;
  if (blocked) {
    const std::string style = fmt::format(R"(stroke="{}" stroke-width="2")", color);
    svg.line({center.x - r, center.y - r}, {center.x + r, center.y + r}, style);
    svg.line({center.x - r, center.y + r}, {center.x + r, center.y - r}, style);
  }
  const double x = center.x - k_light_radius - 8.0;
  svg.text({x, center.y - 1.0}, shorten(light.label, k_longest_light),
           R"(text-anchor="end" font-size="8")");
  const Color& passes = light.note->transmittance;
  const std::string state = blocked                 ? "blocked"
                            : passes == Color(1.0f) ? short_color(light.note->light)
                                                    : "× " + short_color(passes);
  svg.text({x, center.y + 8.0}, state,
           fmt::format(R"(text-anchor="end" font-size="7" fill="{}")", blocked ? color : "#666"));
}

void draw_eye(SvgWriter& svg, const SvgPoint& center, const std::string& fill) {
  const double r = k_radius;
  svg.path(
      fmt::format("M{:.1f} {:.1f}Q{:.1f} {:.1f} {:.1f} {:.1f}Q{:.1f} {:.1f} {:.1f} {:.1f}Z",
                  center.x - 1.4 * r, center.y, center.x, center.y - 1.6 * r, center.x + 1.4 * r,
                  center.y, center.x, center.y + 1.6 * r, center.x - 1.4 * r, center.y),
      R"(fill="#fff" stroke="#222" stroke-width="1.5")");
  svg.circle(center, 0.6 * r, fmt::format(R"(fill="{}" stroke="#222" stroke-width="1.5")", fill));
}

void draw_symbol(SvgWriter& svg, const DiagramNode& node, const SvgPoint& center) {
  const std::string fill = display_color(node.light);
  const std::string stroke = hex(look_of(node.ray).srgb);
  const std::string style =
      fmt::format(R"(fill="{}" stroke="{}" stroke-width="2.5")", fill, stroke);
  switch (node.kind) {
    case Kind::eye:
      draw_eye(svg, center, fill);
      break;
    case Kind::surface:
      svg.circle(center, k_radius, style);
      break;
    case Kind::backdrop:
      svg.rectangle({center.x - k_radius, center.y - k_radius}, 2.0 * k_radius, 2.0 * k_radius,
                    style);
      break;
    case Kind::nothing:
      svg.circle(center, k_radius,
                 fmt::format(R"(fill="none" stroke="{}" stroke-dasharray="3 3")", stroke));
      break;
  }
}

void draw_texts(SvgWriter& svg, const DiagramNode& node, const TreePlace& place) {
  const double x = place.x + k_text_x + (node.kind == Kind::eye ? 6.0 : 0.0);
  double y = place.y + 10.0;
  svg.text({x, y}, shorten(node.name, k_longest_name), R"(font-size="11" font-weight="bold")");
  if (!node.material.empty()) {
    y += k_line;
    svg.text({x, y}, shorten(node.material, k_longest_name), R"(font-style="italic" fill="#555")");
  }
  for (const std::string& term : node.terms) {
    y += k_line;
    svg.text({x, y}, term, R"(font-size="8")");
  }
}

/// Down from the parent past all texts of its row, then straight to the node.
void draw_arrow(SvgWriter& svg, const DiagramNode& node, const SvgPoint& parent, double bend,
                const TreePlace& place) {
  const std::string color = hex(look_of(node.ray).srgb);
  const SvgPoint corner{parent.x, bend};
  const SvgPoint tip{place.x, place.y - (node.kind == Kind::surface ? 1.0 : 0.0)};
  // The rays of a surface share the way down, so it has the colour of neither.
  svg.line(parent, corner, R"(stroke="#999" stroke-width="1.5")");
  svg.line(corner, tip, fmt::format(R"(stroke="{}" stroke-width="1.5")", color));
  svg.arrow_head(corner, tip, fmt::format(R"(fill="{}")", color));
  // On the side that the line does not come from.
  const bool from_right = parent.x > place.x + 1.0;
  svg.text({place.x + (from_right ? -8.0 : 8.0), place.y - 8.0}, node.arrow,
           fmt::format(R"(fill="{}" font-weight="bold" text-anchor="{}")", color,
                       from_right ? "end" : "start"));
}

void draw_legend(SvgWriter& svg, double y) {
  double x = k_margin;
  const auto entry = [&](const char* text) {
    svg.text({x + 28.0, y + 3.0}, text, "");
    x += 28.0 + text_width(text, 9.0) + 16.0;
  };
  for (const RayLook& look : k_ray_looks) {
    const bool shadow = look.name.starts_with("shadow");
    svg.line({x, y}, {x + 22.0, y},
             fmt::format(R"(stroke="{}" stroke-width="1.5"{})", hex(look.srgb),
                         shadow ? R"( stroke-dasharray="4 3")" : ""));
    entry(look.name.data());
  }
  svg.circle({x + 12.0, y}, 7.0, R"(fill="#bcd" stroke="#222" stroke-width="1.5")");
  entry("filled with the light it sends back");
}

void draw_header(SvgWriter& svg, const TraceReport& report) {
  const TraceOptions& options = report.options;
  const std::string sample =
      options.spp > 1 ? fmt::format(", sample {} of {}", options.sample, options.spp) : "";
  svg.text({k_margin, 34.0},
           fmt::format("Ray tree of pixel {},{}", options.pixel->x, options.pixel->y),
           R"(font-size="16" font-weight="bold")");
  svg.text(
      {k_margin, 52.0},
      shorten(fmt::format("{}, {}x{} pixels{}; {}, at most {} deep; {}",
                          printable(options.scene_file), report.size.width, report.size.height,
                          sample, options.integrator, options.max_depth, printable(report.camera)),
              140),
      R"(font-size="10" fill="#555")");
  svg.formula({k_margin, 76.0},
              "I = emitted + L_a k_a O_a + sum over lights f_att L_p [ k_d O_d (n.l) + k_s O_s "
              "(r.v)^n ] + k_r O_s I_reflected + k_t O_t I_transmitted",
              R"(font-size="12")");
  draw_legend(svg, 98.0);
}

}  // namespace

std::string trace_to_svg(const TraceReport& report) {
  const std::vector<DiagramNode> nodes = make_diagram(report);
  std::vector<TreeBox> boxes;
  boxes.reserve(nodes.size());
  for (const DiagramNode& node : nodes) boxes.push_back(box_of(node));
  TreeLayout layout = lay_out(boxes, 18.0, 44.0);
  const double width = std::max(k_least_width, layout.width + 2.0 * k_margin);
  const double left = 0.5 * (width - layout.width);
  for (TreePlace& place : layout.places) place = {place.x + left, place.y + k_header};

  SvgWriter svg;
  draw_header(svg, report);
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const std::size_t parent = nodes[i].parent;
    const SvgPoint start{layout.places[parent].x, layout.places[parent].y + 2.0 * k_radius};
    draw_arrow(svg, nodes[i], start, layout.level_bottoms[parent] + k_header, layout.places[i]);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const SvgPoint center{layout.places[i].x, layout.places[i].y + k_radius};
    for (std::size_t k = 0; k < nodes[i].lights.size(); ++k) {
      draw_light(svg, nodes[i].lights[k], center,
                 {center.x + k_light_x, center.y + static_cast<double>(k) * k_light_row});
    }
    draw_symbol(svg, nodes[i], center);
    draw_texts(svg, nodes[i], layout.places[i]);
  }
  return svg.finish(width, layout.height + k_header + k_margin,
                    fmt::format("Ray tree of pixel {},{} of {}", report.options.pixel->x,
                                report.options.pixel->y, printable(report.options.scene_file)));
}

}  // namespace lume::cli
