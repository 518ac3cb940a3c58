// SPDX-License-Identifier: Apache-2.0
// EXT_mesh_gpu_instancing: what a node shows, once for each element of its accessors.
#pragma once

#include "geometry/math.h"
#include "io/gltf/document.h"

#include <cstddef>
#include <vector>

namespace lume::io::gltf {

/// The places of a node's instances, in the node's space. Without the extension there is one, where
/// the node is.
class InstancePlaces {
 public:
  /// What the extension says has been checked. Throws Error(scene) for sparse indices that are out
  /// of range.
  InstancePlaces(const Document& document, const JsonView& node);

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Not invertible where the file has a rotation of length zero, or values that are not finite.
  [[nodiscard]] geometry::DMat4 matrix(std::size_t instance) const;

 private:
  std::size_t size_ = 1;
  std::vector<geometry::Vec3> translations_;  ///< each empty or of size_ elements
  std::vector<geometry::Vec4> rotations_;     ///< quaternions x, y, z, w
  std::vector<geometry::Vec3> scales_;
};

}  // namespace lume::io::gltf
