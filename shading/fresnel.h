// SPDX-License-Identifier: Apache-2.0
// How much light a smooth boundary reflects, and where the rest goes.
#pragma once

#include "shading/color.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lume::shading {

/// Reflectance at normal incidence between vacuum and a medium of the given index of refraction:
/// ((n - 1) / (n + 1))^2.
[[nodiscard]] inline float normal_reflectance(float ior) {
  const float r = (ior - 1.0f) / (ior + 1.0f);
  return r * r;
}

/// Reflectance at grazing incidence for use with the above: 1, but fading to 0 below the 2% that
/// water, the faintest of real boundaries, has at the normal, so that an index of 1 is no boundary
/// at all (Lagarde and de Rousiers 2014, "Moving Frostbite to PBR").
[[nodiscard]] inline float grazing_reflectance(float f0) { return std::min(1.0f, 50.0f * f0); }

/// Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering", eq. 15:
/// F = F0 + (F90 - F0) (1 - cos)^5. `Value` is a number or a Color.
template <class Value>
[[nodiscard]] Value fresnel_schlick(const Value& f0, const Value& f90, float cosine) {
  const float m = std::clamp(1.0f - cosine, 0.0f, 1.0f);
  const float m2 = m * m;
  return f0 + (f90 - f0) * (m2 * m2 * m);
}

/// Mean of fresnel_schlick over the hemisphere, weighted by the cosine.
[[nodiscard]] inline float fresnel_schlick_average(float f0, float f90) {
  return f0 + (f90 - f0) / 21.0f;
}

/// The Fresnel equations for unpolarized light between dielectrics. `cosine` (>= 0) is that of the
/// angle of incidence, `eta` the index on the incident side over that on the other. 1 under total
/// internal reflection.
[[nodiscard]] inline float fresnel_dielectric(float cosine, float eta) {
  const float sin2_transmitted = eta * eta * std::max(0.0f, 1.0f - cosine * cosine);  // Snell
  if (sin2_transmitted >= 1.0f) return 1.0f;
  const float cos_transmitted = std::sqrt(1.0f - sin2_transmitted);
  const float perpendicular = (eta * cosine - cos_transmitted) / (eta * cosine + cos_transmitted);
  const float parallel = (cosine - eta * cos_transmitted) / (cosine + eta * cos_transmitted);
  return 0.5f * (perpendicular * perpendicular + parallel * parallel);
}

/// Mirrors `v` (which points away from the surface) at the normal: r = 2 (n.v) n - v.
[[nodiscard]] inline Vec3 reflect(const Vec3& v, const Vec3& normal) {
  return 2.0f * dot(normal, v) * normal - v;
}

/// Snell's law: the direction in which light that leaves along `v` (away from the surface, on the
/// normal's side) came through the boundary; none under total internal reflection. `eta` as above.
[[nodiscard]] inline std::optional<Vec3> refract(const Vec3& v, const Vec3& normal, float eta) {
  const float cosine = dot(normal, v);
  const float k = 1.0f - eta * eta * (1.0f - cosine * cosine);
  if (k <= 0.0f) return std::nullopt;
  return (eta * cosine - std::sqrt(k)) * normal - eta * v;
}

}  // namespace lume::shading
