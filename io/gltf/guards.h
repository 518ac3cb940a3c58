// SPDX-License-Identifier: Apache-2.0
// The line of defence: every index, size, range, cycle and type in the JSON is looked at before any
// reader relies on it. What a guard lets through cannot make a reader leave its arrays.
#pragma once

#include "io/gltf/json_view.h"

namespace lume::io::gltf {

/// Runs all the guards below. Throws Error(scene) at the first thing that is wrong.
void check_document(const JsonView& root);

/// glTF 2.x that asks for no extension or version Lume does not have.
void check_asset(const JsonView& root);
/// Buffers, buffer views and accessors: every element lies in its view, every view in its buffer.
void check_accessors(const JsonView& root);
/// Primitives: accessors that exist, with types their attribute allows and equal counts.
void check_meshes(const JsonView& root);
/// Nodes and scenes: a forest, with matrices that are affine.
void check_nodes(const JsonView& root);
/// EXT_mesh_gpu_instancing: accessors of the right types and of equal counts. After the two above.
void check_instancing(const JsonView& root);
/// Animations of nodes: samplers whose accessors fit together, and one channel a property. After
/// the meshes and nodes.
void check_animations(const JsonView& root);
/// Samplers, images and textures.
void check_textures(const JsonView& root);

}  // namespace lume::io::gltf
