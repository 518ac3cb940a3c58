// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/gltf/document.h"
#include "io/gltf/nodes.h"
#include "io/gltf/notes.h"
#include "shading/scene.h"

#include <vector>

namespace lume::io::gltf {

/// Fills the scene's world, cameras, lights and origin with what the nodes place. The scene's
/// materials must have been read; others are added where surfaces need them. `tessellated`: no
/// analytic shapes, but the triangles that stand in for them.
void build_scene(const Document& document, const std::vector<PlacedNode>& nodes, bool tessellated,
                 shading::Scene& scene, Notes& notes);

}  // namespace lume::io::gltf
