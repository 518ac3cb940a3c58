// SPDX-License-Identifier: Apache-2.0
#include "io/color.h"

#include "io/error.h"
#include "io/nearest_name.h"
#include "io/ocio_config.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lume::io {
namespace {

namespace ocio = OCIO_NAMESPACE;
using shading::Color;

constexpr float k_largest = 65504.0f;  // of half: more makes OpenColorIO's ACES views black

/// OpenColorIO turns a whole pixel to NaN if one channel is.
float sanitized(float value) {
  return std::isfinite(value) ? std::clamp(value, -k_largest, k_largest) : 0.0f;
}

float clamped(float value) { return value > 0.0f ? std::min(value, 1.0f) : 0.0f; }

/// The name among `known` that `wanted` means; an empty wish means `fallback`.
std::string pick(const OcioConfig& config, const std::string& what, const std::string& wanted,
                 const std::string& fallback, const std::vector<std::string>& known) {
  const std::string relaxed = relaxed_name(wanted.empty() ? fallback : wanted);
  for (const std::string& name : known) {
    if (relaxed_name(name) == relaxed) return name;
  }
  throw Error(ErrorKind::input_output, "colour configuration " + config.name, "",
              "has no " + what + " '" + wanted + "'" + list_names(wanted, known));
}

std::string default_display(const OcioConfig& config) {
  const char* name = config.config->getDefaultDisplay();
  return name != nullptr ? name : "";
}

std::string default_view(const OcioConfig& config, const std::string& display) {
  if (config.own) return std::string(k_pbr_neutral);
  const char* name = config.config->getDefaultView(display.c_str());
  return name != nullptr ? name : "";
}

}  // namespace

Color tone_map_pbr_neutral(const Color& color) {
  constexpr float k_f90 = 0.04f;              // reflection of a dielectric, taken off the darks
  constexpr float k_compress = 0.8f - k_f90;  // peaks above this are compressed
  constexpr float k_desaturation = 0.15f;

  const float x = std::min({color.x, color.y, color.z});
  const float offset = x <= 2.0f * k_f90 ? x - x * x / (4.0f * k_f90) : k_f90;
  const Color base = color - Color(offset);
  const float peak = shading::max_component(base);
  if (peak <= k_compress) return base;

  const float room = 1.0f - k_compress;
  const float new_peak = 1.0f - room * room / (peak + room - k_compress);
  const float keep = 1.0f / (k_desaturation * (peak - new_peak) + 1.0f);
  return base * (new_peak / peak * keep) + Color(new_peak * (1.0f - keep));
}

struct ViewTransform::State {
  std::string config_name;
  std::string display;
  std::string view;
  bool pbr_neutral = false;
  ocio::ConstCPUProcessorRcPtr processor;

  State(const OcioConfig& config, const std::string& wanted_display, const std::string& wanted_view)
      : config_name(config.name),
        display(pick(config, "display", wanted_display, default_display(config),
                     display_names(config))),
        view(pick(config, "view", wanted_view, default_view(config, display),
                  view_names(config, display))),
        pbr_neutral(config.own && view == k_pbr_neutral),
        processor(make_display_processor(config, display,
                                         pbr_neutral ? std::string(k_plain_view) : view)) {}
};

ViewTransform::ViewTransform() {
  static const auto state =
      std::make_shared<const State>(own_ocio_config(), "sRGB", std::string(k_pbr_neutral));
  state_ = state;
}

ViewTransform::ViewTransform(const ViewRequest& request)
    : state_(std::make_shared<const State>(load_ocio_config(request.config), request.display,
                                           request.view)) {}

void ViewTransform::apply(std::span<Color> pixels) const {
  static_assert(sizeof(Color) == 3 * sizeof(float));
  constexpr std::size_t k_chunk = 4096;  // stays in the cache between the three passes
  while (!pixels.empty()) {
    const std::span<Color> chunk = pixels.first(std::min(pixels.size(), k_chunk));
    for (Color& pixel : chunk) {
      pixel = {sanitized(pixel.x), sanitized(pixel.y), sanitized(pixel.z)};
      if (state_->pbr_neutral) pixel = tone_map_pbr_neutral(glm::max(pixel, Color(0.0f)));
    }
    ocio::PackedImageDesc image(chunk.data(), static_cast<long>(chunk.size()), 1, 3);
    state_->processor->apply(image);
    for (Color& pixel : chunk) pixel = {clamped(pixel.x), clamped(pixel.y), clamped(pixel.z)};
    pixels = pixels.subspan(chunk.size());
  }
}

const std::string& ViewTransform::display() const { return state_->display; }
const std::string& ViewTransform::view() const { return state_->view; }
const std::string& ViewTransform::config_name() const { return state_->config_name; }

std::vector<DisplayViews> available_views(const std::filesystem::path& config) {
  const OcioConfig loaded = load_ocio_config(config);
  std::vector<DisplayViews> result;
  for (const std::string& display : display_names(loaded)) {
    result.push_back({display, view_names(loaded, display)});
  }
  return result;
}

}  // namespace lume::io
