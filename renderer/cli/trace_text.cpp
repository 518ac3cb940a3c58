// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/text.h"
#include "renderer/cli/text_tree.h"
#include "renderer/cli/trace_report.h"
#include "renderer/cli/trace_terms.h"
#include "shading/fresnel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lume::cli {
namespace {

using geometry::Vec3;
using renderer::LightNote;
using renderer::RayNote;
using renderer::SurfaceNote;
using renderer::TwigNote;
using shading::Color;

const Color k_black{0.0f};
const Color k_white{1.0f};

/// "0.25 0.5 1", or one number for grey. Adding zero turns -0 into 0.
std::string show(const Color& c) {
  if (c.x == c.y && c.y == c.z) return fmt::format("{:.6g}", c.x + 0.0f);
  return fmt::format("{:.6g} {:.6g} {:.6g}", c.x + 0.0f, c.y + 0.0f, c.z + 0.0f);
}

std::string quoted(const std::string& name) { return fmt::format("'{}'", printable(name)); }

/// Builds the tree of one sample.
class Teller {
 public:
  explicit Teller(const TraceReport& report) : report_(report), tree_(report.tree()) {}

  [[nodiscard]] TextNode tell_ray(std::size_t index) const;

 private:
  [[nodiscard]] TextNode tell_surface(const RayNote& ray, const SurfaceNote& surface) const;
  [[nodiscard]] TextNode tell_light(const LightNote& light, const RayNote& ray,
                                    const SurfaceNote& surface,
                                    const Coefficients& coefficients) const;
  [[nodiscard]] TextNode tell_ambient(const SurfaceNote& surface,
                                      const Coefficients& coefficients) const;
  void tell_twig(TextNode& node, const char* term, const char* formula, const Color& sum,
                 const std::optional<TwigNote>& twig) const;
  [[nodiscard]] std::string place(const Vec3& position) const {
    return format_vector(geometry::DVec3(position) + report_.scene.origin);
  }

  const TraceReport& report_;
  const renderer::RayTree& tree_;
};

TextNode Teller::tell_ray(std::size_t index) const {
  const RayNote& ray = tree_.rays[index];
  TextNode node;
  node.lines.push_back(fmt::format("{} ray, depth {}: {} -> {}", name_of(ray.kind), ray.depth,
                                   place(ray.ray.origin),
                                   format_vector(geometry::DVec3(ray.ray.direction))));
  for (const SurfaceNote& surface : ray.surfaces) {
    node.children.push_back(tell_surface(ray, surface));
  }
  if (ray.backdrop) {
    node.children.push_back({{fmt::format("the backdrop: {}", show(*ray.backdrop))}, {}});
  } else if (ray.surfaces.empty()) {
    node.children.push_back({{"nothing: 0"}, {}});
  }
  return node;
}

TextNode Teller::tell_surface(const RayNote& ray, const SurfaceNote& surface) const {
  const Coefficients coefficients = coefficients_at(report_.scene, ray, surface);
  const shading::Material& material = *coefficients.point.material;
  const geometry::Hit& hit = surface.point.hit;
  TextNode node;
  std::string heading =
      fmt::format("t = {:.6g}: {}, material {}{}", distance_to(ray, surface),
                  quoted(object_name(report_.scene, hit)),
                  quoted(material_name(report_.scene, hit)), surface.inside ? ", from inside" : "");
  if (coefficients.equivalent && !material.unlit) heading += "; coefficients: the equivalent ones";
  node.lines.push_back(heading);
  if (coefficients.point.coverage < 1.0f) {
    node.lines.push_back(
        fmt::format("covers {:.6g} of what lies behind it", coefficients.point.coverage));
  }
  const renderer::LightTerms& terms = surface.terms;
  if (terms.emitted != k_black) {
    node.children.push_back({{fmt::format("emitted {}{}", show(terms.emitted),
                                          material.unlit ? ", the base colour: it is unlit" : "")},
                             {}});
  }
  if (terms.ambient != k_black) node.children.push_back(tell_ambient(surface, coefficients));
  for (std::size_t i = 0; i < surface.light_count; ++i) {
    const LightNote& light = tree_.lights[surface.first_light + i];
    node.children.push_back(tell_light(light, ray, surface, coefficients));
  }
  tell_twig(node, "reflected", "k_r O_s", terms.reflected, surface.reflection);
  tell_twig(node, "transmitted", "k_t O_t", terms.transmitted, surface.transmission);
  std::string sum = "I = " + show(terms.sum());
  if (surface.scale != k_white) {
    sum += fmt::format("; x {} = {} for coverage and absorption on the way", show(surface.scale),
                       show(surface.scale * terms.sum()));
  }
  node.children.push_back({{sum}, {}});
  return node;
}

TextNode Teller::tell_ambient(const SurfaceNote& surface, const Coefficients& coefficients) const {
  std::string line = fmt::format("ambient {} = L_a {} x k_a O_a {}", show(surface.terms.ambient),
                                 show(report_.scene.ambient), show(coefficients.ambient()));
  if (coefficients.point.occlusion < 1.0f) {
    line += fmt::format(" x occlusion map {:.6g}", coefficients.point.occlusion);
  }
  if (surface.unoccluded < 1.0f) line += fmt::format(" x unoccluded {:.6g}", surface.unoccluded);
  return {{line}, {}};
}

TextNode Teller::tell_light(const LightNote& light, const RayNote& ray, const SurfaceNote& surface,
                            const Coefficients& coefficients) const {
  const Vec3 to_light = direction_to_light(light, surface.point);
  const Vec3& normal = coefficients.point.normal;
  const float n_l = std::max(0.0f, dot(normal, to_light));
  const float r_v = std::max(0.0f, dot(shading::reflect(-ray.ray.direction, normal), to_light));
  TextNode node;
  const auto position = light_position(light);
  node.lines.push_back(
      fmt::format("shadow ray to {} {}: {}", quoted(light_name(report_.scene, light)),
                  position ? "at " + place(*position)
                           : "along " + format_vector(geometry::DVec3(light.ray.direction)),
                  is_blocked(light)                ? "blocked"
                  : light.transmittance == k_white ? "arrives"
                                                   : show(light.transmittance) + " of it arrives"));
  // Where the coefficients are equivalent ones the product is near the term, not equal to it.
  const char* equals = coefficients.equivalent ? "~" : "=";
  const std::string passes =
      light.transmittance == k_white ? "" : " x transmittance " + show(light.transmittance);
  const std::string arriving = fmt::format("f_att L_p {}{}", show(light.light), passes);
  if (light.diffuse != k_black) {
    node.lines.push_back(fmt::format("diffuse {} {} k_d O_d {} x n.l {:.6g} x {}",
                                     show(light.diffuse), equals, show(coefficients.diffuse()), n_l,
                                     arriving));
  }
  if (light.specular != k_black) {
    node.lines.push_back(fmt::format("specular {} {} k_s O_s {} x (r.v {:.6g})^{:.6g} x {}",
                                     show(light.specular), equals, show(coefficients.specular()),
                                     r_v, coefficients.phong.shininess, arriving));
  }
  return node;
}

void Teller::tell_twig(TextNode& node, const char* term, const char* formula, const Color& sum,
                       const std::optional<TwigNote>& twig) const {
  if (!twig) return;
  const Color light = resum(tree_, twig->ray).sum();
  TextNode& child = node.children.emplace_back();
  child.lines.push_back(fmt::format("{} {} = {} {} x I {}", term, show(sum), formula,
                                    show(twig->weight), show(light)));
  child.children.push_back(tell_ray(twig->ray));
}

std::string heading(const TraceReport& report) {
  const TraceOptions& options = report.options;
  const renderer::RayCounts& rays = report.trace.rays;
  const renderer::Radiance& value = report.trace.value;
  const Color color = value.color();
  std::string text = fmt::format("scene   {}\n", printable(options.scene_file));
  text += fmt::format("view    {}x{} pixels, {}; light: {}\n", report.size.width,
                      report.size.height, report.camera, report.light);
  text += fmt::format("method  {}, {}, {} sample{} a pixel, seed {}\n", options.integrator,
                      options.integrator == "raycast"
                          ? std::string("no recursion")
                          : fmt::format("at most {} deep", options.max_depth),
                      options.spp, options.spp == 1 ? "" : "s", options.seed);
  text += fmt::format("pixel   {},{}: {:.6g} {:.6g} {:.6g}, alpha {:.6g}\n", options.pixel->x,
                      options.pixel->y, color.x, color.y, color.z, value.alpha);
  return text + fmt::format("rays    {} camera, {} shadow, {} reflection, {} refraction\n\n",
                            format_count(rays.camera), format_count(rays.shadow),
                            format_count(rays.reflection), format_count(rays.refraction));
}

std::string conclusion(const TraceReport& report) {
  const auto numbers = [](const Color& c) {
    return fmt::format("{:.6g} {:.6g} {:.6g}", c.x, c.y, c.z);
  };
  const std::string sum = numbers(resum(report.tree()).sum());
  if (report.options.spp == 1) {
    return fmt::format("\nThe terms add up to {}: the same as the pixel, to the last bit.\n", sum);
  }
  return fmt::format(
      "\nThe terms add up to {}: the same as the sample, to the last bit.\n"
      "The mean of all {} samples is {}: the same as the pixel, to the last bit.\n",
      sum, report.options.spp, numbers(report.trace.value.color()));
}

}  // namespace

std::string trace_to_text(const TraceReport& report) {
  std::string text = heading(report);
  text +=
      "I = emitted + L_a k_a O_a + sum over lights f_att L_p [k_d O_d (n.l) + k_s O_s (r.v)^n]\n"
      "  + k_r O_s I_reflected + k_t O_t I_transmitted\n\n";
  if (report.options.spp > 1) {
    text += fmt::format("Sample {} of {}:\n", report.options.sample, report.options.spp);
  }
  return text + draw_tree(Teller(report).tell_ray(0)) + conclusion(report);
}

}  // namespace lume::cli
