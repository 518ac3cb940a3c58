// SPDX-License-Identifier: Apache-2.0
// Everything there is to meet: objects, each with a hierarchy of its own, and instances of them.
#pragma once

#include "geometry/bounds.h"
#include "geometry/geometry.h"
#include "geometry/hit.h"
#include "geometry/transform.h"

#include <string>
#include <vector>

namespace lume::geometry {

/// What moves as one and is built once: the primitives of a glTF mesh.
struct Object {
  std::string name;
  std::vector<Geometry> geometries;

  /// Around all that has an end, in the object's space.
  [[nodiscard]] Bounds bounds() const;
};

/// An object placed in the scene's frame.
struct Instance {
  std::string name;
  std::uint32_t object = 0;  ///< index into World::objects
  Transform transform;
};

struct World {
  std::vector<Object> objects;
  std::vector<Instance> instances;

  [[nodiscard]] const Geometry& geometry(const Hit& hit) const {
    return objects[instances[hit.instance].object].geometries[hit.geometry];
  }
  [[nodiscard]] const Transform& transform(const Hit& hit) const {
    return instances[hit.instance].transform;
  }
  /// Around all instances, in the scene's frame, but for surfaces without an end; empty for a world
  /// without any.
  [[nodiscard]] Bounds bounds() const;
};

}  // namespace lume::geometry
