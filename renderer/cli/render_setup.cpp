// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/render_setup.h"

#include "renderer/cli/counting.h"
#include "renderer/cli/output_name.h"
#include "renderer/cli/picture.h"
#include "renderer/cli/render_stats.h"

#include <algorithm>
#include <utility>

namespace lume::cli {
namespace {

constexpr int k_single_frame = 1;

renderer::RenderSettings render_settings(const RenderOptions& options, const ImageSize& size) {
  renderer::RenderSettings settings{
      pixel_settings(options, size), choose_region(options.crop, size), {}};
  for (const renderer::AovInfo& info : renderer::aov_infos()) {
    const bool asked =
        std::find(options.aovs.begin(), options.aovs.end(), info.name) != options.aovs.end();
    if (asked) settings.aovs.push_back(info.aov);
  }
  return settings;
}

/// Whether the accelerator can tell what is asked of it is known once it is built.
void check_cost_aovs(const RenderOptions& options, const RenderSetup& setup) {
  const auto& aovs = setup.settings.aovs;
  if (std::any_of(aovs.begin(), aovs.end(), renderer::is_of_cost)) {
    check_counts_cost("--aov", options.accelerator, setup.prepared->accelerator());
  }
}

}  // namespace

io::WriteOptions prepare_outputs(const RenderOptions& options) {
  for (const std::string& output : options.outputs) {
    io::check_writable(frame_path(output, k_single_frame));
  }
  if (options.stats) check_text_writable(*options.stats);

  io::WriteOptions write;
  const bool any_display =
      std::any_of(options.outputs.begin(), options.outputs.end(),
                  [](const auto& output) { return is_display_format(output); });
  const bool asked = !options.display.empty() || !options.view.empty() || !options.ocio.empty();
  // A broken $OCIO is no reason not to write scene-linear files.
  if (any_display || asked) {
    write.view = io::ViewTransform({options.ocio, options.display, options.view});
  }
  write.exposure = options.exposure;
  write.full_float = options.full_float;
  write.compression = options.compression;
  write.jpeg_quality = options.jpeg_quality;
  return write;
}

void load(RenderSetup& setup, const RenderOptions& options) {
  setup.loaded = load_scene(options);
  setup.viewpoint = choose_viewpoint(setup.loaded.scene, options);
  setup.settings = render_settings(options, setup.viewpoint.size);
  setup.light = light_scene(options, setup.loaded.scene);
}

void build(RenderSetup& setup, const RenderOptions& options) {
  setup.prepared.emplace(setup.loaded.scene, options.accelerator);
  check_cost_aovs(options, setup);
}

void aim(RenderSetup& setup, const RenderOptions& options) {
  focus(setup.viewpoint, options, *setup.prepared);
  setup.prepared->prepare_view(setup.viewpoint.camera.camera, setup.viewpoint.size.width,
                               setup.viewpoint.size.height);
}

renderer::RenderResult trace(const RenderSetup& setup, const RenderOptions& options,
                             const renderer::RenderControl& control) {
  const auto integrator =
      renderer::make_integrator(options.integrator, *setup.prepared, integrator_settings(options));
  return renderer::render_image(*setup.prepared, setup.viewpoint.camera.camera, *integrator,
                                setup.settings, control);
}

io::Picture develop(const RenderSetup& setup, const RenderOptions& options,
                    renderer::RenderResult& result, const io::WriteOptions& write) {
  const CameraChoice& camera = setup.viewpoint.camera;
  io::Picture picture =
      make_picture(std::move(result.film), setup.viewpoint.size, options.full_float);
  picture.metadata = describe_picture(options, camera.description, write.view);
  if (result.cancelled) picture.metadata["lume:incomplete"] = "interrupted";
  picture.world_to_camera = world_to_camera(camera.camera, setup.loaded.scene.origin);
  return picture;
}

}  // namespace lume::cli
