// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/lighting.h"

#include "io/image_io.h"
#include "renderer/cli/text.h"
#include "renderer/emitter_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>

namespace lume::cli {
namespace {

/// A texture that glows no brighter than white paints lamps and screens on a model; it is not meant
/// to light anything.
bool is_lamp(const shading::Material& material) {
  const bool only_glows =
      material.emission_texture && shading::max_component(material.emission) <= 1.0f;
  return material.is_emissive() && !only_glows;
}

/// Whether light is looked for on the surface, so that it reaches others.
bool can_light(const geometry::Geometry& geometry) {
  const geometry::Mesh* mesh = geometry.mesh();
  return mesh != nullptr ? !mesh->triangles.empty() : renderer::is_area_light(*geometry.shape());
}

bool has_lamp(const shading::Scene& scene, const geometry::Object& object) {
  return std::any_of(object.geometries.begin(), object.geometries.end(),
                     [&](const geometry::Geometry& geometry) {
                       return can_light(geometry) && geometry.material < scene.materials.size() &&
                              is_lamp(scene.materials[geometry.material]);
                     });
}

std::string use_environment_file(const ViewOptions& options, shading::Scene& scene) {
  shading::Environment environment = io::read_environment(*options.environment);
  environment.rotate(options.environment_rotation * std::numbers::pi_v<float> / 180.0f);
  environment.scale(options.environment_intensity);
  environment.visible = !options.environment_hidden;
  scene.environment = std::move(environment);
  return fmt::format("environment {}", printable(*options.environment));
}

}  // namespace

bool has_light(const shading::Scene& scene) {
  if (!scene.lights.empty() || scene.environment || scene.ambient != shading::Color(0.0f))
    return true;
  const auto& instances = scene.world.instances;
  return std::any_of(instances.begin(), instances.end(), [&](const geometry::Instance& instance) {
    return has_lamp(scene, scene.world.objects[instance.object]);
  });
}

std::string light_scene(const ViewOptions& options, shading::Scene& scene) {
  if (options.ambient) scene.ambient = shading::Color(*options.ambient);
  if (options.environment) return use_environment_file(options, scene);
  if (options.background) {
    scene.environment = shading::Environment(shading::Color(*options.background));
    return fmt::format("{} nits from everywhere", format_vector(*options.background));
  }
  if (has_light(scene)) return "the scene's own";
  scene.environment = shading::studio_environment();
  return "Lume's studio, for the scene has none (--env, --background)";
}

}  // namespace lume::cli
