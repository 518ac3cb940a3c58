// SPDX-License-Identifier: Apache-2.0
// Normals and tangents as files have them: not quite unit, sometimes zero, now and then NaN.
#pragma once

#include "geometry/mesh.h"

namespace lume::io::gltf {

/// Makes all normals unit vectors. Those without a direction are replaced by the mean of the
/// normals of the triangles around them, weighted by area. Returns how many were replaced.
std::size_t repair_normals(geometry::Mesh& mesh);

/// Makes all tangents unit vectors with a handedness of 1 or -1. Those without a direction are
/// replaced by some vector across the normal.
void repair_tangents(geometry::Mesh& mesh);

}  // namespace lume::io::gltf
