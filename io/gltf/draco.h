// SPDX-License-Identifier: Apache-2.0
// KHR_draco_mesh_compression: primitives whose indices and attributes are one compressed mesh. They
// are decoded before anybody reads them, so that for the reader of meshes they are like all others.
#pragma once

#include "io/gltf/document.h"

namespace lume::io::gltf {

/// tinygltf insists on data behind the indices of a primitive: those of compressed primitives are
/// taken out of what it is to see.
void hide_compressed_indices(Json& structure);

/// Decodes all compressed primitives, on several threads, and gives them accessors of their own in
/// document.model; attributes that are not compressed keep theirs. Also where the file has the
/// same uncompressed. After the buffer views that are compressed themselves. Throws Error(scene)
/// for data that are damaged or are not what the accessors say.
void decode_draco_primitives(Document& document);

}  // namespace lume::io::gltf
