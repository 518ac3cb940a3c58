// SPDX-License-Identifier: Apache-2.0
// From scene-linear light to what a display shows, through OpenColorIO.
#pragma once

#include "shading/color.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lume::io {

/// Khronos PBR Neutral tone mapping of linear Rec.709, exact (not through a LUT).
/// Source: KhronosGroup/ToneMapping, PBR_Neutral.
[[nodiscard]] shading::Color tone_map_pbr_neutral(const shading::Color& color);

struct ViewRequest {
  std::filesystem::path config;  ///< an OCIO file; empty: $OCIO if set, else Lume's own
  std::string display;           ///< empty: the configuration's default
  std::string view;              ///< empty: "PBR Neutral" (Lume's own configuration) or its default
};

/// A display transform that is ready to run; copies share it. The default one is PBR Neutral on
/// sRGB.
class ViewTransform {
 public:
  ViewTransform();
  /// Throws Error(input_output) for a configuration that cannot be used and for an unknown display
  /// or view; the message names the nearest and lists those there are.
  explicit ViewTransform(const ViewRequest& request);

  /// In place: linear Rec.709 (not premultiplied) to encoded display values in [0, 1]. Values that
  /// are not finite count as 0.
  void apply(std::span<shading::Color> pixels) const;

  [[nodiscard]] const std::string& display() const;
  [[nodiscard]] const std::string& view() const;
  [[nodiscard]] const std::string& config_name() const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

/// A display and its views, as `lume render --help` and errors list them.
struct DisplayViews {
  std::string display;
  std::vector<std::string> views;
};
[[nodiscard]] std::vector<DisplayViews> available_views(const std::filesystem::path& config = {});

}  // namespace lume::io
