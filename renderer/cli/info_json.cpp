// SPDX-License-Identifier: Apache-2.0
#include "lume_version.h"
#include "renderer/cli/info_report.h"
#include "renderer/cli/scene_counts.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace lume::cli {
namespace {

using Json = nlohmann::ordered_json;

template <class Vector>
Json vector_to_json(const Vector& v) {
  return {v.x + 0, v.y + 0, v.z + 0};  // no -0
}

double degrees(float radians) { return static_cast<double>(radians) * 180.0 / std::numbers::pi; }

Json counts_to_json(const io::LoadedScene& loaded, const SceneCounts& counts) {
  const shading::Scene& scene = loaded.scene;
  return {{"scenes", loaded.scene_names.size()},
          {"instances", scene.world.instances.size()},
          {"meshes", scene.world.objects.size()},
          {"primitives", counts.primitives},
          {"triangles", counts.triangles},
          {"triangles_instanced", counts.triangles_instanced},
          {"shapes", counts.shapes},
          {"shapes_instanced", counts.shapes_instanced},
          {"vertices", counts.vertices},
          {"materials", scene.materials.size()},
          {"textures", scene.textures.size()},
          {"images", scene.images.size()},
          {"cameras", scene.cameras.size()},
          {"lights", scene.lights.size()}};
}

Json bounds_to_json(const shading::Scene& scene) {
  const auto bounds = world_bounds(scene);
  if (!bounds) return nullptr;
  return {{"lower", vector_to_json(bounds->lower)}, {"upper", vector_to_json(bounds->upper)}};
}

Json camera_to_json(const geometry::Camera& camera, const geometry::DVec3& origin) {
  const bool perspective = camera.projection == geometry::Camera::Projection::perspective;
  Json json = {{"name", camera.name},
               {"projection", perspective ? "perspective" : "orthographic"},
               {"position", vector_to_json(geometry::DVec3(camera.position) + origin)},
               {"direction", vector_to_json(-camera.backward)},
               {"up", vector_to_json(camera.up)}};
  if (perspective) json["vertical_fov_degrees"] = degrees(camera.vertical_fov);
  if (!perspective) json["half_height_metres"] = camera.half_height;
  json["aspect"] = camera.aspect > 0.0f ? Json(camera.aspect) : Json(nullptr);
  return json;
}

Json light_to_json(const shading::PunctualLight& light, const geometry::DVec3& origin) {
  using Kind = shading::PunctualLight::Kind;
  const bool directional = light.kind == Kind::directional;
  Json json = {
      {"name", light.name},
      {"kind", kind_name(light.kind)},
      {"intensity", vector_to_json(light.intensity)},
      {"unit", light_unit(light.kind)},
      {"radiometric", vector_to_json(geometry::DVec3(light.intensity) / k_lumens_per_watt)},
      {"radiometric_unit", directional ? "W/m^2" : "W/sr"}};
  if (!directional) {
    json["position"] = vector_to_json(geometry::DVec3(light.position) + origin);
    if (light.attenuation) json["attenuation"] = vector_to_json(*light.attenuation);
    json["range_metres"] = std::isfinite(light.range) ? Json(light.range) : Json(nullptr);
  }
  if (light.kind != Kind::point) json["direction"] = vector_to_json(light.direction);
  if (light.kind == Kind::spot) {
    json["inner_cone_degrees"] = degrees(light.inner_cone);
    json["outer_cone_degrees"] = degrees(light.outer_cone);
  }
  return json;
}

Json image_to_json(const shading::Image& image) {
  return {{"name", image.name},
          {"width", image.width},
          {"height", image.height},
          {"bytes", decoded_bytes(image)}};
}

Json extension_to_json(const io::ExtensionUse& extension) {
  return {{"name", extension.name},
          {"support", support_name(extension.support)},
          {"remark", extension.remark},
          {"required", extension.required}};
}

template <class Items, class Convert>
Json list_to_json(const Items& items, Convert convert) {
  Json list = Json::array();
  for (const auto& item : items) list.push_back(convert(item));
  return list;
}

}  // namespace

std::string info_to_json(const io::LoadedScene& loaded, const std::string& file) {
  const shading::Scene& scene = loaded.scene;
  const SceneCounts counts = count_scene(scene);
  const std::string scene_name =
      loaded.scene_index < loaded.scene_names.size() ? loaded.scene_names[loaded.scene_index] : "";
  const Json json = {
      {"lume", k_version},
      {"file", file},
      {"generator", loaded.generator},
      {"copyright", loaded.copyright},
      {"scenes", Json(loaded.scene_names)},
      {"scene", {{"index", loaded.scene_index}, {"name", scene_name}}},
      {"counts", counts_to_json(loaded, counts)},
      {"bounds", bounds_to_json(scene)},
      {"cameras",
       list_to_json(scene.cameras, [&](const auto& c) { return camera_to_json(c, scene.origin); })},
      {"lights",
       list_to_json(scene.lights, [&](const auto& l) { return light_to_json(l, scene.origin); })},
      {"materials",
       list_to_json(scene.materials,
                    [](const shading::Material& m) -> Json {
                      return {{"name", m.name}, {"features", Json(material_features(m))}};
                    })},
      {"images", list_to_json(scene.images, image_to_json)},
      {"extensions", list_to_json(loaded.extensions, extension_to_json)},
      {"notes", Json(loaded.notes)},
      {"memory_bytes",
       {{"meshes", counts.mesh_bytes},
        {"images", counts.image_bytes},
        {"accelerator", counts.accelerator_bytes},
        {"total", counts.total_bytes()}}},
  };
  // Names that are not UTF-8 must not make the JSON invalid.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lume::cli
