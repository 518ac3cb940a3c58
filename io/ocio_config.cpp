// SPDX-License-Identifier: Apache-2.0
#include "io/ocio_config.h"

#include "io/error.h"
#include "io/one_line.h"

#include <array>
#include <cstdlib>
#include <sstream>

namespace lume::io {

// Written by the build from assets/color/lume.ocio.
extern const std::string_view k_embedded_ocio_config;

namespace {

namespace ocio = OCIO_NAMESPACE;

[[noreturn]] void fail(const OcioConfig& config, const std::string& reason) {
  throw Error(ErrorKind::input_output, config.name, "", one_line(reason));
}

/// Under which of its usual names a configuration knows linear Rec.709; empty if under none.
std::string find_rec709_space(const ocio::ConstConfigRcPtr& config) {
  constexpr std::array k_usual_names = {"lin_rec709",
                                        "lin_rec709_scene",
                                        "lin_rec709_srgb",
                                        "Linear Rec.709 (sRGB)",
                                        "Utility - Linear - sRGB",
                                        "Utility - Linear - Rec.709",
                                        "Linear Rec.709",
                                        "Linear BT.709",
                                        "Linear sRGB",
                                        "lin_srgb"};
  for (const char* name : k_usual_names) {
    const ocio::ConstColorSpaceRcPtr space = config->getColorSpace(name);
    if (space && !space->isData()) return space->getName();
  }
  return {};
}

ocio::ConstProcessorRcPtr make_processor(const OcioConfig& config, const std::string& display,
                                         const std::string& view) {
  const auto to_display = [&](const std::string& source) {
    return config.config->getProcessor(source.c_str(), display.c_str(), view.c_str(),
                                       ocio::TRANSFORM_DIR_FORWARD);
  };
  const std::string rec709 = find_rec709_space(config.config);
  if (!rec709.empty()) return to_display(rec709);

  // What is left is to trust that scene_linear has our primaries.
  if (!config.config->hasRole(ocio::ROLE_SCENE_LINEAR)) {
    fail(config,
         "has neither a linear Rec.709 colour space (such as lin_rec709) nor a role "
         "scene_linear");
  }
  return to_display(ocio::ROLE_SCENE_LINEAR);
}

OcioConfig read_config(const std::filesystem::path& path, const std::string& origin) {
  OcioConfig result{nullptr, path.string(), false};
  try {
    result.config = ocio::Config::CreateFromFile(path.c_str());
    result.config->validate();
  } catch (const std::exception& error) {
    fail(result, "cannot use the OpenColorIO configuration" + origin + ": " + error.what());
  }
  return result;
}

}  // namespace

const OcioConfig& own_ocio_config() {
  static const OcioConfig own = [] {
    std::istringstream stream{std::string(k_embedded_ocio_config)};
    return OcioConfig{ocio::Config::CreateFromStream(stream), "lume", true};
  }();
  return own;
}

OcioConfig load_ocio_config(const std::filesystem::path& path) {
  if (!path.empty()) return read_config(path, "");
  const char* variable = std::getenv("OCIO");
  if (variable == nullptr || *variable == '\0') return own_ocio_config();
  return read_config(variable, " that $OCIO names");
}

std::vector<std::string> display_names(const OcioConfig& config) {
  std::vector<std::string> names;
  names.reserve(static_cast<std::size_t>(config.config->getNumDisplays()));
  for (int i = 0; i < config.config->getNumDisplays(); ++i) {
    names.emplace_back(config.config->getDisplay(i));
  }
  return names;
}

std::vector<std::string> view_names(const OcioConfig& config, const std::string& display) {
  std::vector<std::string> names;
  if (config.own) names.emplace_back(k_pbr_neutral);
  for (int i = 0; i < config.config->getNumViews(display.c_str()); ++i) {
    names.emplace_back(config.config->getView(display.c_str(), i));
  }
  return names;
}

ocio::ConstCPUProcessorRcPtr make_display_processor(const OcioConfig& config,
                                                    const std::string& display,
                                                    const std::string& view) {
  try {
    return make_processor(config, display, view)->getDefaultCPUProcessor();
  } catch (const ocio::Exception& error) {
    fail(config, "view " + view + " of display " + display + " does not work: " + error.what());
  }
}

}  // namespace lume::io
