// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/gltf/json_view.h"
#include "io/gltf/notes.h"

#include <span>
#include <string>
#include <string_view>

namespace lume::io::gltf {

/// A property that nobody reads is most likely a mistyped one: notes every one of `object` that is
/// not among those which `owner` has; `subject` is whose note it is.
void note_unknown_properties(const JsonView& object, std::string_view owner,
                             std::span<const std::string_view> properties,
                             const std::string& subject, Notes& notes);

}  // namespace lume::io::gltf
