// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/view.h"

#include "renderer/cli/exit_codes.h"
#include "renderer/cli/text.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <string>
#include <vector>

namespace lume::cli {
namespace {

void log_notes(const std::vector<std::string>& notes, const std::string& scene_file) {
  constexpr std::size_t k_shown = 10;
  for (std::size_t i = 0; i < std::min(notes.size(), k_shown); ++i) {
    spdlog::info("note: {}", printable(notes[i]));
  }
  if (notes.size() > k_shown) {
    spdlog::info("... and {} more; lume info {} lists them", notes.size() - k_shown,
                 shell_quote(printable(scene_file)));
  }
}

}  // namespace

io::LoadedScene load_scene(const ViewOptions& options) {
  io::LoadOptions load;
  load.scene = options.scene;
  load.time = options.time;
  load.animation = options.animation;
  load.tessellated = options.tessellated;
  io::LoadedScene loaded = io::load_gltf(options.scene_file, load);
  log_notes(loaded.notes, options.scene_file);
  return loaded;
}

Viewpoint choose_viewpoint(const shading::Scene& scene, const ViewOptions& options) {
  const geometry::Camera* file_camera = find_file_camera(scene, options);
  const ImageSize size = choose_size(options, file_camera != nullptr ? file_camera->aspect : 0.0f);
  return {size, choose_camera(scene, options, file_camera, size.aspect())};
}

void focus(Viewpoint& viewpoint, const ViewOptions& options,
           const renderer::PreparedScene& prepared) {
  if (!options.aperture) return;
  geometry::Camera& camera = viewpoint.camera.camera;
  camera.lens_radius = 0.5f * *options.aperture;
  if (options.focus) {
    camera.focus_distance = *options.focus;
    return;
  }
  const auto middle =
      prepared.first_surface(camera.generate_ray({0.5f, 0.5f}, viewpoint.size.aspect()));
  if (!middle) {
    throw UsageError(
        "--aperture: nothing is in the middle of the picture to focus on; give --focus");
  }
  camera.focus_distance = camera.depth(middle->position);
  spdlog::info("in focus: {:.4g} m from the camera", camera.focus_distance);
}

renderer::PixelSettings pixel_settings(const ViewOptions& options, const ImageSize& size) {
  const auto filters = renderer::PixelFilter::names();
  const auto kind = std::find(filters.begin(), filters.end(), options.filter) - filters.begin();
  return {
      size.width, size.height, options.spp, options.seed,
      renderer::PixelFilter(static_cast<renderer::PixelFilter::Kind>(kind), options.filter_radius)};
}

renderer::IntegratorSettings integrator_settings(const ViewOptions& options) {
  return {options.max_depth, options.cutoff, !options.no_shadows, options.occlusion_distance};
}

}  // namespace lume::cli
