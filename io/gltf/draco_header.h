// SPDX-License-Identifier: Apache-2.0
// The beginning of a Draco mesh, looked at before the decoder believes it: it allocates what the
// header says.
#pragma once

#include "io/gltf/glb.h"

#include <cstdint>
#include <optional>

namespace lume::io::gltf {

/// That the bytes begin like a mesh of a version that glTF allows, with as many faces as were
/// announced and not more than so many bytes may hold. Throws std::runtime_error with the reason
/// alone.
void check_draco_header(Bytes bytes, std::optional<std::uint64_t> announced_faces);

}  // namespace lume::io::gltf
