// SPDX-License-Identifier: Apache-2.0
// The way from the options of `lume render` to a picture, step by step and without a word, for
// those commands that render.
#pragma once

#include "io/image_io.h"
#include "renderer/cli/render_options.h"
#include "renderer/cli/view.h"
#include "renderer/render.h"

#include <optional>
#include <string>

namespace lume::cli {

/// How the outputs are to be written. Whatever could fail at the end fails here. Throws io::Error
/// and UsageError.
[[nodiscard]] io::WriteOptions prepare_outputs(const RenderOptions& options);

/// A scene on its way to a picture. It stays where it is, for its parts know each other.
struct RenderSetup {
  RenderSetup() = default;
  RenderSetup(const RenderSetup&) = delete;
  RenderSetup& operator=(const RenderSetup&) = delete;
  ~RenderSetup() = default;

  io::LoadedScene loaded;
  Viewpoint viewpoint;
  renderer::RenderSettings settings;
  std::string light;  ///< what lights the scene, for the log
  std::optional<renderer::PreparedScene> prepared;
};

// In this order. All throw io::Error and UsageError.
void load(RenderSetup& setup, const RenderOptions& options);
void build(RenderSetup& setup, const RenderOptions& options);
void aim(RenderSetup& setup, const RenderOptions& options);
[[nodiscard]] renderer::RenderResult trace(const RenderSetup& setup, const RenderOptions& options,
                                           const renderer::RenderControl& control);
/// Takes the film's pixels.
[[nodiscard]] io::Picture develop(const RenderSetup& setup, const RenderOptions& options,
                                  renderer::RenderResult& result, const io::WriteOptions& write);

}  // namespace lume::cli
