// SPDX-License-Identifier: Apache-2.0
// From the options of a view to what the renderer wants to know.
#pragma once

#include "io/gltf/load_gltf.h"
#include "renderer/cli/camera_choice.h"
#include "renderer/cli/lighting.h"
#include "renderer/cli/view_options.h"
#include "renderer/pixel.h"
#include "renderer/prepared_scene.h"

namespace lume::cli {

/// Loads the scene and logs what is noteworthy in it. Throws io::Error.
[[nodiscard]] io::LoadedScene load_scene(const ViewOptions& options);

/// From where the scene is seen, and on how many pixels.
struct Viewpoint {
  ImageSize size;
  CameraChoice camera;
};

[[nodiscard]] Viewpoint choose_viewpoint(const shading::Scene& scene, const ViewOptions& options);

/// Gives the camera its lens, in focus where the options say or on what the middle of the picture
/// shows. Throws UsageError if that is nothing.
void focus(Viewpoint& viewpoint, const ViewOptions& options,
           const renderer::PreparedScene& prepared);

[[nodiscard]] renderer::PixelSettings pixel_settings(const ViewOptions& options,
                                                     const ImageSize& size);
[[nodiscard]] renderer::IntegratorSettings integrator_settings(const ViewOptions& options);

}  // namespace lume::cli
