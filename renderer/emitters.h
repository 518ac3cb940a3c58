// SPDX-License-Identifier: Apache-2.0
// The emissive triangles of a scene as area lights.
#pragma once

#include "geometry/surface_point.h"
#include "shading/distribution.h"
#include "shading/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace lume::renderer {

using geometry::Vec2;
using geometry::Vec3;

/// A point on an emissive triangle, as seen from somewhere.
struct EmitterSample {
  geometry::Hit hit;
  Vec2 uv{0.0f};          ///< barycentric
  Vec3 position{0.0f};    ///< scene frame
  float area_pdf = 0.0f;  ///< per m^2
  Vec3 normal{0.0f};      ///< geometric, unit
};

class Emitters {
 public:
  explicit Emitters(const shading::Scene& scene);

  [[nodiscard]] bool empty() const { return triangles_.empty(); }
  [[nodiscard]] std::size_t size() const { return triangles_.size(); }
  /// Draws a triangle in proportion to area times mean luminance, then a point uniformly on it.
  /// Not for an empty set.
  [[nodiscard]] EmitterSample sample(float choice, Vec2 random) const;
  /// The density per m^2 with which sample() returns points of a triangle; 0 if it does not emit.
  [[nodiscard]] float area_pdf(const geometry::Hit& hit) const;

 private:
  struct Triangle {
    geometry::Hit hit;
    float area = 0.0f;  ///< m^2
  };
  const shading::Scene* scene_;
  std::vector<Triangle> triangles_;
  /// For each instance and geometry the index of its first triangle, or k_none.
  static constexpr std::uint32_t k_none = ~0u;
  std::vector<std::vector<std::uint32_t>> first_;
  std::optional<shading::Distribution1D> distribution_;
};

}  // namespace lume::renderer
