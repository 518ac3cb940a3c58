// SPDX-License-Identifier: Apache-2.0
// Finding a colour configuration and what is in it; only for io/color.cpp, so that no public header
// needs OpenColorIO.
#pragma once

#include <OpenColorIO/OpenColorIO.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lume::io {

/// The view that Lume computes itself: tone_map_pbr_neutral(), then k_plain_view.
inline constexpr std::string_view k_pbr_neutral = "PBR Neutral";
/// The view without tone mapping in Lume's own configuration.
inline constexpr std::string_view k_plain_view = "Standard";

struct OcioConfig {
  OCIO_NAMESPACE::ConstConfigRcPtr config;
  std::string name;  ///< "lume", or the path of the file
  bool own = false;  ///< Lume's own configuration, which also has PBR Neutral
};

/// The file at `path`; if that is empty the one that $OCIO names, else Lume's own. Throws
/// Error(input_output).
[[nodiscard]] OcioConfig load_ocio_config(const std::filesystem::path& path);
/// The configuration in assets/color/lume.ocio, which is compiled into the library.
[[nodiscard]] const OcioConfig& own_ocio_config();

[[nodiscard]] std::vector<std::string> display_names(const OcioConfig& config);
/// The default view comes first in Lume's own configuration.
[[nodiscard]] std::vector<std::string> view_names(const OcioConfig& config,
                                                  const std::string& display);

/// The transform from linear Rec.709 to a display. Throws Error(input_output).
[[nodiscard]] OCIO_NAMESPACE::ConstCPUProcessorRcPtr make_display_processor(
    const OcioConfig& config, const std::string& display, const std::string& view);

}  // namespace lume::io
