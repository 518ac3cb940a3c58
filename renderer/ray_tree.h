// SPDX-License-Identifier: Apache-2.0
// The tree of rays behind one sample of a pixel, for people to look at: the integrators note it
// while they work when they are given one to fill. What is noted is enough to add the sample up
// again, to the last bit.
#pragma once

#include "geometry/surface_point.h"
#include "renderer/radiance.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lume::renderer {

enum class RayKind { camera, reflection, refraction };

/// A shadow ray, and the light that came along it.
struct LightNote {
  enum class Kind { environment, emitter, punctual };

  Kind kind = Kind::punctual;
  std::uint32_t index = 0;    ///< of a punctual light in Scene::lights
  geometry::Hit emitter;      ///< the emissive surface
  geometry::Ray ray;          ///< from the surface to the light
  Color light{0.0f};          ///< L_p f_att, before shadows: illuminance / pi (nits)
  Color transmittance{0.0f};  ///< 1: not in shadow
  Color diffuse{0.0f};        ///< what it adds to the term
  Color specular{0.0f};
};

/// A ray that a surface sent out.
struct TwigNote {
  std::size_t ray = 0;  ///< index into RayTree::rays
  Color weight{0.0f};   ///< what its light was multiplied by
};

/// A surface that a ray met, with what it sent back.
struct SurfaceNote {
  geometry::SurfacePoint point;
  bool inside = false;          ///< the ray ran inside of the solid that the surface bounds
  Color scale{0.0f};            ///< coverage times what was absorbed on the way there
  LightTerms terms;             ///< before `scale`
  float unoccluded = 1.0f;      ///< part of the ambient light that arrives
  std::size_t first_light = 0;  ///< its shadow rays: indices into RayTree::lights
  std::size_t light_count = 0;
  std::optional<TwigNote> reflection;
  std::optional<TwigNote> transmission;
};

/// A ray with all that it met, in order: more than one surface where some are alpha-blended.
struct RayNote {
  RayKind kind = RayKind::camera;
  int depth = 0;  ///< reflections and refractions before it
  geometry::Ray ray;
  std::vector<SurfaceNote> surfaces;
  std::optional<Color> backdrop;  ///< what it saw behind all surfaces, if it went so far
};

struct RayTree {
  std::vector<RayNote> rays;  ///< the camera's first; each stands before those it led to
  std::vector<LightNote> lights;
};

/// Adds a ray's light up from what is noted of its leaves and weights, by the formula.
[[nodiscard]] LightTerms resum(const RayTree& tree, std::size_t ray = 0);

}  // namespace lume::renderer
