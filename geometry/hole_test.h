// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/hit.h"
#include "geometry/math.h"

namespace lume::geometry {

/// Says where a surface has a hole (alpha-masked texels). Called from inside traversals, on many
/// threads at once, only for geometries with has_holes.
class HoleTest {
 public:
  HoleTest() = default;
  HoleTest(const HoleTest&) = delete;
  HoleTest& operator=(const HoleTest&) = delete;
  virtual ~HoleTest() = default;
  /// True if the surface is absent there: at barycentric (u, v) of the named triangle, at texture
  /// coordinates (u, v) of the named shape.
  [[nodiscard]] virtual bool is_hole(const Hit& hit, Vec2 uv) const = 0;
};

}  // namespace lume::geometry
