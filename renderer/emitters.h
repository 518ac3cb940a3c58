// SPDX-License-Identifier: Apache-2.0
// The emissive triangles, spheres, rectangles and disks of a scene as area lights.
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

/// A point of an emissive surface, as seen from somewhere.
struct EmitterSample {
  geometry::Hit hit;
  Vec2 uv{0.0f};        ///< as SurfacePoint::uv
  Vec3 position{0.0f};  ///< scene frame
  Vec3 normal{0.0f};    ///< geometric, unit
  float pdf = 0.0f;     ///< of the direction to it, per steradian; 0: of no use from there
};

class Emitters {
 public:
  explicit Emitters(const shading::Scene& scene);

  [[nodiscard]] bool empty() const { return emitters_.empty(); }
  [[nodiscard]] std::size_t size() const { return emitters_.size(); }
  /// Draws an emitter in proportion to area times mean luminance, then a point of it as seen from
  /// `from`. Not for an empty set.
  [[nodiscard]] EmitterSample sample(float choice, Vec2 random, const Vec3& from) const;
  /// The density per steradian with which sample() returns the direction from `from` to a point of
  /// a surface; 0 if that does not emit, or cannot be aimed at.
  [[nodiscard]] float pdf(const geometry::SurfacePoint& met, const Vec3& from) const;

 private:
  /// A triangle or a whole shape.
  struct Emitter {
    geometry::Hit hit;
    float area = 0.0f;  ///< m^2, of the scene's frame
  };
  [[nodiscard]] float direction_pdf(std::size_t index, const Vec3& position, const Vec3& normal,
                                    const Vec3& from) const;

  const shading::Scene* scene_;
  std::vector<Emitter> emitters_;
  /// For each instance and geometry the index of its first emitter, or k_none.
  static constexpr std::uint32_t k_none = ~0u;
  std::vector<std::vector<std::uint32_t>> first_;
  std::optional<shading::Distribution1D> distribution_;
};

/// The emissive surfaces that are seen and mirrored but light nothing, since there is no aiming at
/// shapes of their kind; hit.primitive is 0.
[[nodiscard]] std::vector<geometry::Hit> unsampled_emitters(const shading::Scene& scene);

}  // namespace lume::renderer
