// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shading/color.h"

#include <limits>
#include <optional>
#include <string>

namespace lume::shading {

/// A light without extent (KHR_lights_punctual), placed in the scene's frame.
struct PunctualLight {
  enum class Kind { directional, point, spot };

  std::string name;
  Kind kind = Kind::point;
  /// Colour * intensity. Point and spot: luminous intensity, cd = lm/sr. Directional: illuminance
  /// on a surface that faces it, lx = lm/m^2.
  Color intensity{1.0f};
  Vec3 position{0.0f};
  Vec3 direction{0.0f, 0.0f, -1.0f};                     ///< unit, the way the light travels
  float range = std::numeric_limits<float>::infinity();  ///< metres; no light beyond it
  /// The course's constants c1, c2 (1/m), c3 (1/m^2) (extension LUME_materials_phong): in place of
  /// 1 / d^2 the light falls off by f_att = min(1, 1 / (c1 + c2 d + c3 d^2)).
  std::optional<Vec3> attenuation;
  float inner_cone = 0.0f;                   ///< radians from the axis; full intensity within
  float outer_cone = geometry::k_pi / 4.0f;  ///< radians from the axis; no light outside
};

/// Light that arrives at a point from one place.
struct Incidence {
  Color illuminance{0.0f};  ///< on a surface that faces the light, before shadows (lx)
  Vec3 to_light{0.0f};      ///< unit
  float distance = std::numeric_limits<float>::infinity();  ///< metres
};

/// What the light sends to `point` if nothing is in the way. Falls off with the square of the
/// distance, or by the course's f_att where the light has its constants, windowed by the range as
/// KHR_lights_punctual recommends: max(min(1 - (d/r)^4, 1), 0) / d^2.
[[nodiscard]] Incidence illuminate(const PunctualLight& light, const Vec3& point);

}  // namespace lume::shading
