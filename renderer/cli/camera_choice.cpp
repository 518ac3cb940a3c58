// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/camera_choice.h"

#include "renderer/cli/exit_codes.h"
#include "renderer/cli/suggest.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace lume::cli {
namespace {

using geometry::Camera;
using geometry::DVec3;
using geometry::Vec3;

constexpr double k_default_fov = 45.0;  // degrees
constexpr double k_max_side = 65535.0;  // pixels

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

std::string camera_label(const shading::Scene& scene, const Camera& camera) {
  const std::string label = fmt::format("camera {}", &camera - scene.cameras.data());
  const bool is_named = !camera.name.empty() && camera.name != label;
  return is_named ? fmt::format("{} '{}'", label, printable(camera.name)) : label;
}

CameraChoice orbit_camera(const shading::Scene& scene, const ViewOptions& options) {
  const geometry::Bounds bounds = scene.world.bounds();
  const Vec3 center = bounds.is_empty() ? Vec3(0.0f) : bounds.center();
  // What is typed is in the world; the scene's frame may lie elsewhere.
  const Vec3 target = options.target ? Vec3(*options.target - scene.origin) : center;
  const DVec3 orbit = *options.orbit;
  const double fov = options.fov ? static_cast<double>(*options.fov) : k_default_fov;
  return {geometry::orbit(target, static_cast<float>(radians(orbit.x)),
                          static_cast<float>(radians(orbit.y)), static_cast<float>(orbit.z),
                          static_cast<float>(radians(fov))),
          fmt::format("on an orbit around {}", format_vector(DVec3(target) + scene.origin))};
}

CameraChoice framing_camera(const shading::Scene& scene, const ViewOptions& options,
                            float image_aspect) {
  const geometry::Bounds bounds = scene.world.bounds();
  CameraChoice choice{Camera(), "framing the scene"};
  if (!bounds.is_empty()) choice.camera = geometry::frame_bounds(bounds, image_aspect);
  if (options.fov) {
    choice.camera.vertical_fov = static_cast<float>(radians(static_cast<double>(*options.fov)));
  }
  return choice;
}

}  // namespace

const Camera* find_file_camera(const shading::Scene& scene, const ViewOptions& options) {
  if (options.orbit) return nullptr;
  const std::vector<Camera>& cameras = scene.cameras;
  if (!options.camera) return cameras.empty() ? nullptr : cameras.data();

  const std::string& wanted = *options.camera;
  const auto named = std::find_if(cameras.begin(), cameras.end(),
                                  [&](const Camera& camera) { return camera.name == wanted; });
  if (named != cameras.end()) return &*named;
  std::size_t index = 0;
  const char* end = wanted.data() + wanted.size();
  const auto parsed = std::from_chars(wanted.data(), end, index);
  if (parsed.ec == std::errc() && parsed.ptr == end && index < cameras.size()) {
    return &cameras[index];
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    names.push_back(cameras[i].name.empty() ? std::to_string(i) : cameras[i].name);
  }
  throw UsageError(unknown_name("camera", wanted, names));
}

ImageSize choose_size(const ViewOptions& options, float camera_aspect) {
  constexpr int k_default_width = 1280;
  const bool has_shape = std::isfinite(camera_aspect) && camera_aspect > 0.0f;
  const double aspect = has_shape ? static_cast<double>(camera_aspect) : 16.0 / 9.0;
  const auto side = [](double pixels) {
    return static_cast<int>(std::clamp(std::round(pixels), 1.0, k_max_side));
  };
  if (options.width && options.height) return {*options.width, *options.height};
  if (options.height) return {side(*options.height * aspect), *options.height};
  const int width = options.width.value_or(k_default_width);
  return {width, side(width / aspect)};
}

shading::PixelRegion choose_region(const std::optional<shading::PixelRegion>& crop,
                                   const ImageSize& size) {
  constexpr std::int64_t k_max_pixels = std::int64_t{1} << 28;  // 4 GiB of RGBA floats
  const shading::PixelRegion region =
      crop.value_or(shading::PixelRegion{0, 0, size.width, size.height});
  if (region.x + region.width > size.width || region.y + region.height > size.height) {
    throw UsageError(fmt::format("--crop: {}x{}+{}+{} reaches outside the picture of {}x{} pixels",
                                 region.width, region.height, region.x, region.y, size.width,
                                 size.height));
  }
  if (std::int64_t{region.width} * region.height > k_max_pixels) {
    throw UsageError(
        fmt::format("{}x{} is too much for one picture; up to {} pixels are possible, "
                    "larger pictures in parts with --crop",
                    region.width, region.height, k_max_pixels));
  }
  return region;
}

CameraChoice choose_camera(const shading::Scene& scene, const ViewOptions& options,
                           const Camera* file_camera, float image_aspect) {
  if (options.orbit) return orbit_camera(scene, options);
  if (file_camera == nullptr) return framing_camera(scene, options, image_aspect);

  CameraChoice choice{*file_camera, camera_label(scene, *file_camera)};
  if (options.fov) {
    if (file_camera->projection == Camera::Projection::orthographic) {
      throw UsageError(
          fmt::format("--fov: {} is orthographic and has no field of view", choice.description));
    }
    choice.camera.vertical_fov = static_cast<float>(radians(static_cast<double>(*options.fov)));
  }
  return choice;
}

}  // namespace lume::cli
