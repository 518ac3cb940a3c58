// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderer/cli/view_options.h"
#include "shading/scene.h"

#include <string>

namespace lume::cli {

struct ImageSize {
  int width = 0;
  int height = 0;
  [[nodiscard]] float aspect() const {
    return static_cast<float>(width) / static_cast<float>(height);
  }
};

/// The camera of the file that the options ask for by name or number, or its first; null if there
/// is none or --orbit places one. Throws UsageError for one that is not there.
[[nodiscard]] const geometry::Camera* find_file_camera(const shading::Scene& scene,
                                                       const ViewOptions& options);

/// What is not asked for follows from the camera's shape (width / height; 0: none, then 16:9).
/// Throws UsageError for a picture or crop that is impossible or too large.
[[nodiscard]] ImageSize choose_size(const ViewOptions& options, float camera_aspect);

/// The rectangle to render: the crop, or all of it. Throws UsageError if the crop leaves the
/// picture.
[[nodiscard]] shading::PixelRegion choose_region(const std::optional<shading::PixelRegion>& crop,
                                                 const ImageSize& size);

/// A camera and where it comes from, for the log.
struct CameraChoice {
  geometry::Camera camera;
  std::string description;
};

/// The camera of the file if there is one, else one on the orbit or one that frames the scene.
[[nodiscard]] CameraChoice choose_camera(const shading::Scene& scene, const ViewOptions& options,
                                         const geometry::Camera* file_camera, float image_aspect);

}  // namespace lume::cli
