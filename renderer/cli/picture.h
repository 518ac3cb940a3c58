// SPDX-License-Identifier: Apache-2.0
// From a film to what is written to files.
#pragma once

#include "io/image_io.h"
#include "renderer/cli/camera_choice.h"
#include "renderer/cli/render_options.h"
#include "renderer/film.h"
#include "shading/scene.h"

#include <map>
#include <string>
#include <vector>

namespace lume::cli {

/// Row-major, for row vectors: (x, y, z, 1) of the world times it is the place as the camera sees
/// it, x to the right, y up, looking along -z.
[[nodiscard]] std::vector<float> world_to_camera(const geometry::Camera& camera,
                                                 const geometry::DVec3& origin);

/// What a picture says of itself. Neither times nor thread counts: the same command gives the same
/// bytes.
[[nodiscard]] std::map<std::string, std::string> describe_picture(const RenderOptions& options,
                                                                  const std::string& camera,
                                                                  const io::ViewTransform& view);

/// Takes the film's pixels and layers; `full_float` keeps every layer in 32 bits.
[[nodiscard]] io::Picture make_picture(renderer::Film film, const ImageSize& size, bool full_float);

}  // namespace lume::cli
