// SPDX-License-Identifier: Apache-2.0
#include "tests/images/own_scenes.h"

#include "io/gltf/load_gltf.h"
#include "tests/support/paths.h"

#include <algorithm>
#include <utility>

namespace lume::tests {
namespace {

std::filesystem::path scenes_folder() { return source_dir() / "assets" / "scenes"; }

}  // namespace

std::vector<std::string> own_scene_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(scenes_folder())) {
    const std::filesystem::path& path = entry.path();
    const bool is_scene = path.extension() == ".gltf" || path.extension() == ".glb";
    if (is_scene) names.push_back(path.stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

shading::Scene lit(shading::Scene scene) {
  if (scene.lights.empty() && renderer::Emitters(scene).empty()) {
    scene.environment = shading::studio_environment();
  }
  return scene;
}

renderer::RenderResult render_scene(shading::Scene scene, const geometry::Camera& camera,
                                    const Shot& shot) {
  scene = lit(std::move(scene));
  const renderer::PreparedScene prepared(scene, shot.accelerator);
  const auto integrator =
      renderer::make_integrator(renderer::integrator_names().front(), prepared, {});
  renderer::RenderSettings settings;
  settings.width = shot.width;
  settings.height = shot.height;
  settings.spp = shot.spp;
  settings.region = shot.region;
  settings.aovs = shot.aovs;
  return renderer::render_image(prepared, camera, *integrator, settings);
}

shading::Scene load_own_scene(const std::string& name, bool tessellated) {
  const bool is_text = exists(scenes_folder() / (name + ".gltf"));
  const std::filesystem::path path = scenes_folder() / (name + (is_text ? ".gltf" : ".glb"));
  io::LoadOptions options;
  options.tessellated = tessellated;
  return io::load_gltf(path, options).scene;
}

renderer::RenderResult render_own_scene(const std::string& name, const Shot& shot) {
  const shading::Scene scene = load_own_scene(name, shot.tessellated);
  return render_scene(scene, scene.cameras.at(0), shot);
}

}  // namespace lume::tests
