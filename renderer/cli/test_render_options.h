// SPDX-License-Identifier: Apache-2.0
// The options of `lume render` that a manifest gives a case.
#pragma once

#include "io/image_tests/manifest.h"
#include "renderer/cli/render_options.h"

namespace lume::cli {

/// Reads them as `lume render` would. Relative paths start in the manifest's folder. What the
/// manifest says elsewhere (scene, outputs) and what makes no sense in a test is refused. Throws
/// io::ManifestError.
[[nodiscard]] RenderOptions read_render_options(const io::Manifest& manifest,
                                                const io::TestCase& test);

}  // namespace lume::cli
