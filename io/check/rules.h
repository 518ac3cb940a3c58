// SPDX-License-Identifier: Apache-2.0
// The rules, one family a file. They see the file as it is written and the scene that was made of
// it; neither is changed.
#pragma once

#include "io/check/finding.h"
#include "io/gltf/document.h"
#include "io/gltf/load_gltf.h"

namespace lume::io::check {

struct Subject {
  const gltf::Document& document;
  const LoadedScene& loaded;
};

/// Extensions that are not honoured, not declared, or declared for nothing.
void check_extensions(const Subject& subject, Findings& findings);
/// Glass, metal, transparency and glow that do not look as was meant.
void check_materials(const Subject& subject, Findings& findings);
/// What a primitive lacks for its material, and geometry that shows nothing.
void check_primitives(const Subject& subject, Findings& findings);
/// Values in accessors that contradict the file or the specification.
void check_values(const Subject& subject, Findings& findings);
/// Intensities that look like watts, and a scene without light.
void check_lights(const Subject& subject, Findings& findings);
/// Size and place of the whole.
void check_extent(const Subject& subject, Findings& findings);
/// Parts of the file that no scene uses.
void check_unused(const Subject& subject, Findings& findings);
/// Rules of glTF that a file can break and still be drawn as its author saw it.
void check_tolerated(const Subject& subject, Findings& findings);

}  // namespace lume::io::check
