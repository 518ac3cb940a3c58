// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/picture.h"

#include "lume_version.h"
#include "renderer/aov.h"
#include "renderer/cli/version.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace lume::cli {

std::vector<float> world_to_camera(const geometry::Camera& camera, const geometry::DVec3& origin) {
  using geometry::DVec3;
  const DVec3 axes[3] = {DVec3(camera.right), DVec3(camera.up), DVec3(camera.backward)};
  const DVec3 eye = DVec3(camera.position) + origin;
  std::vector<float> matrix(16, 0.0f);
  for (std::size_t column = 0; column < 3; ++column) {
    const DVec3& axis = axes[column];
    matrix[0 + column] = static_cast<float>(axis.x);
    matrix[4 + column] = static_cast<float>(axis.y);
    matrix[8 + column] = static_cast<float>(axis.z);
    matrix[12 + column] = static_cast<float>(-dot(eye, axis));
  }
  matrix[15] = 1.0f;
  return matrix;
}

std::map<std::string, std::string> describe_picture(const RenderOptions& options,
                                                    const std::string& camera,
                                                    const io::ViewTransform& view) {
  std::string libraries;
  for (const LibraryVersion& library : library_versions()) {
    libraries +=
        fmt::format("{}{} {}", libraries.empty() ? "" : ", ", library.name, library.version);
  }
  return {
      {"lume:scene", std::filesystem::path(options.scene_file).filename().string()},
      {"lume:camera", camera},
      {"lume:integrator", options.integrator},
      {"lume:accelerator", options.accelerator},
      {"lume:spp", std::to_string(options.spp)},
      {"lume:seed", std::to_string(options.seed)},
      {"lume:max_depth", std::to_string(options.max_depth)},
      {"lume:filter", options.filter},
      {"lume:exposure", fmt::format("{}", options.exposure)},
      {"lume:view", fmt::format("{} / {}", view.display(), view.view())},
      {"lume:version", std::string(k_version)},
      {"lume:libraries", libraries},
  };
}

io::Picture make_picture(renderer::Film film, const ImageSize& size, bool full_float) {
  io::Picture picture;
  picture.full_width = size.width;
  picture.full_height = size.height;
  picture.region = film.region;
  picture.pixels = std::move(film.pixels);
  for (renderer::Film::Layer& layer : film.layers) {
    const renderer::AovInfo& info = renderer::aov_infos()[static_cast<std::size_t>(layer.aov)];
    io::Layer written;
    written.channels.assign(info.channels.begin(), info.channels.end());
    written.pixels = std::move(layer.values);
    written.full_precision = full_float || info.source == renderer::AovSource::center;
    picture.layers.push_back(std::move(written));
  }
  return picture;
}

}  // namespace lume::cli
