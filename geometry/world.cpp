// SPDX-License-Identifier: Apache-2.0
#include "geometry/world.h"

namespace lume::geometry {

Bounds Object::bounds() const {
  Bounds result;
  for (const Geometry& geometry : geometries) {
    const Bounds bounds = geometry.bounds();
    if (bounds.is_finite()) result.add(bounds);
  }
  return result;
}

Bounds World::bounds() const {
  std::vector<Bounds> object_bounds(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) object_bounds[i] = objects[i].bounds();
  Bounds result;
  for (const Instance& instance : instances) {
    result.add(instance.transform.bounds_to_world(object_bounds[instance.object]));
  }
  return result;
}

}  // namespace lume::geometry
