// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/info_report.h"
#include "renderer/cli/scene_counts.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lume::cli {
namespace {

constexpr std::size_t k_label_width = 12;

std::string line(std::string_view label, const std::string& value) {
  return fmt::format("{:<{}}{}\n", label, k_label_width, value);
}

std::string item(std::size_t index, const std::string& name, std::size_t name_width,
                 const std::string& value) {
  return fmt::format("  {:>3}  {:<{}}  {}\n", index, printable(name), name_width, value);
}

/// The width of the column for names, within reason.
template <class Items>
std::size_t name_width(const Items& items) {
  std::size_t width = 0;
  for (const auto& one : items) width = std::max(width, one.name.size());
  return std::min<std::size_t>(width, 32);
}

template <class Items, class Describe>
std::string section(const std::string& title, const Items& items, Describe describe) {
  if (items.empty()) return "";
  std::string text = fmt::format("\n{}\n", title);
  const std::size_t width = name_width(items);
  for (std::size_t i = 0; i < items.size(); ++i) {
    text += item(i, items[i].name, width, describe(items[i]));
  }
  return text;
}

double degrees(float radians) { return static_cast<double>(radians) * 180.0 / std::numbers::pi; }

std::string describe_camera(const geometry::Camera& camera, const geometry::DVec3& origin) {
  const bool perspective = camera.projection == geometry::Camera::Projection::perspective;
  const std::string lens =
      perspective ? fmt::format("perspective, {:.4g} deg high", degrees(camera.vertical_fov))
                  : fmt::format("orthographic, {:.4g} m high", 2.0f * camera.half_height);
  const std::string shape =
      camera.aspect > 0.0f ? fmt::format(", aspect {:.4g}", camera.aspect) : "";
  return fmt::format("{}{}, at {} looking along {}", lens, shape,
                     format_vector(geometry::DVec3(camera.position) + origin),
                     format_vector(-geometry::DVec3(camera.backward)));
}

std::string describe_light(const shading::PunctualLight& light, const geometry::DVec3& origin) {
  using Kind = shading::PunctualLight::Kind;
  std::string text =
      fmt::format("{}, {} {}", kind_name(light.kind),
                  format_vector(geometry::DVec3(light.intensity)), light_unit(light.kind));
  if (light.kind != Kind::directional) {
    text += " at " + format_vector(geometry::DVec3(light.position) + origin);
  }
  if (light.kind != Kind::point) {
    text += " along " + format_vector(geometry::DVec3(light.direction));
  }
  if (light.kind == Kind::spot) {
    text += fmt::format(", cone {:.4g} to {:.4g} deg", degrees(light.inner_cone),
                        degrees(light.outer_cone));
  }
  if (light.attenuation) {
    text += ", attenuation " + format_vector(geometry::DVec3(*light.attenuation));
  }
  if (std::isfinite(light.range)) text += fmt::format(", range {:.4g} m", light.range);
  return text;
}

std::string join(const std::vector<std::string>& parts) {
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string summary(const io::LoadedScene& loaded, const SceneCounts& counts) {
  const shading::Scene& scene = loaded.scene;
  std::string text;
  text +=
      line("geometry",
           fmt::format("{} triangles ({} as placed), {} vertices", format_count(counts.triangles),
                       format_count(counts.triangles_instanced), format_count(counts.vertices)));
  if (counts.shapes > 0) {
    text += line("", fmt::format("{} analytic shapes ({} as placed)", format_count(counts.shapes),
                                 format_count(counts.shapes_instanced)));
  }
  text +=
      line("", fmt::format("{} meshes of {} primitives, {} instances", scene.world.objects.size(),
                           counts.primitives, scene.world.instances.size()));
  text +=
      line("looks", fmt::format("{} materials, {} textures of {} images", scene.materials.size(),
                                scene.textures.size(), scene.images.size()));
  const auto bounds = world_bounds(scene);
  text += line("bounds", bounds ? fmt::format("{} to {} m", format_vector(bounds->lower),
                                              format_vector(bounds->upper))
                                : "none, there is no geometry");
  text +=
      line("memory",
           fmt::format("about {}: meshes {}, images {}, accelerator {}",
                       format_bytes(counts.total_bytes()), format_bytes(counts.mesh_bytes),
                       format_bytes(counts.image_bytes), format_bytes(counts.accelerator_bytes)));
  return text;
}

std::string heading(const io::LoadedScene& loaded, const std::string& file) {
  std::string text = line("file", printable(file));
  if (!loaded.generator.empty()) text += line("generator", printable(loaded.generator));
  if (!loaded.copyright.empty()) text += line("copyright", printable(loaded.copyright));
  if (loaded.scene_index < loaded.scene_names.size()) {
    text += line("scene", fmt::format("{} '{}' of {}", loaded.scene_index,
                                      printable(loaded.scene_names[loaded.scene_index]),
                                      loaded.scene_names.size()));
  }
  if (loaded.scene_names.size() > 1) text += line("scenes", list_names(loaded.scene_names));
  return text;
}

std::string describe_extension(const io::ExtensionUse& extension) {
  return fmt::format("{}{}{}{}", support_name(extension.support),
                     extension.required ? ", required" : "", extension.remark.empty() ? "" : ": ",
                     printable(extension.remark));
}

}  // namespace

std::string info_to_text(const io::LoadedScene& loaded, const std::string& file) {
  const shading::Scene& scene = loaded.scene;
  std::string text = heading(loaded, file) + summary(loaded, count_scene(scene));
  text += section("cameras", scene.cameras, [&](const geometry::Camera& camera) {
    return describe_camera(camera, scene.origin);
  });
  text += section(
      "lights (683 cd = 1 W/sr, 683 lx = 1 W/m^2)", scene.lights,
      [&](const shading::PunctualLight& light) { return describe_light(light, scene.origin); });
  text += section("materials", scene.materials, [](const shading::Material& material) {
    return join(material_features(material));
  });
  text += section("images", scene.images, [](const shading::Image& image) {
    return fmt::format("{}x{}, {}", image.width, image.height, format_bytes(decoded_bytes(image)));
  });
  text += section("extensions", loaded.extensions, describe_extension);
  if (!loaded.notes.empty()) text += "\nnotes\n";
  for (const std::string& note : loaded.notes) text += "  " + printable(note) + "\n";
  return text;
}

}  // namespace lume::cli
