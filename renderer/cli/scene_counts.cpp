// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/scene_counts.h"

#include <fmt/format.h>

#include <algorithm>

namespace lume::cli {
namespace {

/// Embree's robust triangle hierarchies of a million triangles, measured.
constexpr std::uint64_t k_accelerator_bytes_per_triangle = 90;

std::uint64_t triangles_of(const geometry::Object& object) {
  std::uint64_t count = 0;
  for (const geometry::Geometry& geometry : object.geometries) {
    if (const geometry::Mesh* mesh = geometry.mesh()) count += mesh->triangles.size();
  }
  return count;
}

std::uint64_t shapes_of(const geometry::Object& object) {
  return static_cast<std::uint64_t>(
      std::count_if(object.geometries.begin(), object.geometries.end(),
                    [](const geometry::Geometry& each) { return each.shape() != nullptr; }));
}

std::string alpha_feature(const shading::Material& material) {
  if (material.alpha_mode == shading::AlphaMode::mask) {
    return fmt::format("alpha mask {:.3g}", material.alpha_cutoff);
  }
  return material.alpha_mode == shading::AlphaMode::blend ? "alpha blend" : "";
}

std::string phong_feature(const shading::Phong& phong) {
  return fmt::format(
      "Phong: k_a {:.3g}, k_d {:.3g}, k_s {:.3g}, n {:.4g}, k_r {:.3g}, k_t {:.3g}{}",
      phong.ambient, phong.diffuse, phong.specular, phong.shininess, phong.reflection,
      phong.transmission, phong.fresnel ? ", Fresnel" : "");
}

}  // namespace

SceneCounts count_scene(const shading::Scene& scene) {
  SceneCounts counts;
  for (const geometry::Object& object : scene.world.objects) {
    counts.primitives += object.geometries.size();
    counts.triangles += triangles_of(object);
    counts.shapes += shapes_of(object);
    for (const geometry::Geometry& geometry : object.geometries) {
      if (const geometry::Mesh* mesh = geometry.mesh()) {
        counts.vertices += mesh->positions.size();
        counts.mesh_bytes += mesh->memory_bytes();
      }
    }
  }
  for (const geometry::Instance& instance : scene.world.instances) {
    const geometry::Object& object = scene.world.objects[instance.object];
    counts.triangles_instanced += triangles_of(object);
    counts.shapes_instanced += shapes_of(object);
  }
  for (const shading::Image& image : scene.images) counts.image_bytes += decoded_bytes(image);
  counts.accelerator_bytes = counts.triangles * k_accelerator_bytes_per_triangle;
  return counts;
}

std::uint64_t decoded_bytes(const shading::Image& image) {
  // The variant's alternatives are 8, 16 and 32 bit, also while they hold no texels.
  const std::uint64_t bytes_per_value = std::uint64_t{1} << image.texels.index();
  return 4 * bytes_per_value * static_cast<std::uint64_t>(image.width) *
         static_cast<std::uint64_t>(image.height);
}

std::optional<WorldBounds> world_bounds(const shading::Scene& scene) {
  const geometry::Bounds bounds = scene.world.bounds();
  if (bounds.is_empty()) return std::nullopt;
  return WorldBounds{scene.origin + geometry::DVec3(bounds.lower),
                     scene.origin + geometry::DVec3(bounds.upper)};
}

std::vector<std::string> material_features(const shading::Material& material) {
  std::vector<std::string> features;
  const auto add = [&](bool present, const std::string& feature) {
    if (present && !feature.empty()) features.push_back(feature);
  };
  add(material.unlit, "unlit");
  add(bool(material.base_color_texture), "base color texture");
  if (material.phong) {
    add(true, phong_feature(*material.phong));
  } else {
    add(bool(material.metallic_roughness_texture), "metallic-roughness texture");
    add(!material.metallic_roughness_texture && !material.unlit,
        fmt::format("metallic {:.3g}, roughness {:.3g}", material.metallic, material.roughness));
    add(material.specular != 1.0f || material.specular_color != shading::Color(1.0f),
        fmt::format("specular {:.3g}", material.specular));
    add(material.transmission > 0.0f, fmt::format("transmission {:.3g}", material.transmission));
    add(bool(material.transmission_texture), "transmission texture");
  }
  add(bool(material.normal_texture), "normal texture");
  add(bool(material.occlusion_texture), "occlusion texture");
  add(bool(material.emission_texture), "emission texture");
  add(material.is_emissive(),
      fmt::format("emits up to {:.4g} nits", shading::max_component(material.emission)));
  add(true, alpha_feature(material));
  add(material.double_sided, "double-sided");
  add(material.is_solid(), "solid (volume)");
  add(material.ior != 1.5f, fmt::format("ior {:.4g}", material.ior));
  return features;
}

std::string_view kind_name(shading::PunctualLight::Kind kind) {
  switch (kind) {
    case shading::PunctualLight::Kind::directional:
      return "directional";
    case shading::PunctualLight::Kind::spot:
      return "spot";
    case shading::PunctualLight::Kind::point:
      break;
  }
  return "point";
}

std::string_view light_unit(shading::PunctualLight::Kind kind) {
  return kind == shading::PunctualLight::Kind::directional ? "lx" : "cd";
}

std::string_view support_name(io::Support support) {
  switch (support) {
    case io::Support::full:
      return "full";
    case io::Support::partial:
      return "partial";
    case io::Support::ignored:
      break;
  }
  return "ignored";
}

}  // namespace lume::cli
