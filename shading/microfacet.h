// SPDX-License-Identifier: Apache-2.0
// The GGX distribution of microfacets (Trowbridge and Reitz 1975; Walter, Marschner, Li, Torrance
// 2007, "Microfacet Models for Refraction through Rough Surfaces"). All vectors are unit vectors in
// the local frame whose z is the macroscopic normal; alpha is the width, the square of glTF's
// roughness.
#pragma once

#include "shading/color.h"

#include <algorithm>
#include <cmath>

namespace lume::shading {

/// Density of microfacet normals h (Walter et al. 2007, eq. 33): its projection on the macroscopic
/// surface integrates to 1 over the hemisphere.
[[nodiscard]] inline float ggx_distribution(const Vec3& h, float alpha) {
  if (h.z <= 0.0f) return 0.0f;
  const float a2 = alpha * alpha;
  // 1 - z^2 from x and y: near the pole a difference of nearly equal numbers would lose the peak.
  const float d = (h.x * h.x + h.y * h.y) + a2 * h.z * h.z;
  return a2 / (geometry::k_pi * d * d);
}

/// Smith's Lambda (Heitz 2014, "Understanding the Masking-Shadowing Function", eq. 72).
[[nodiscard]] inline float smith_lambda(const Vec3& v, float alpha) {
  const float tan2 = (v.x * v.x + v.y * v.y) / (v.z * v.z);
  return 0.5f * (std::sqrt(1.0f + alpha * alpha * tan2) - 1.0f);
}

/// Part of the microfacets that is seen from v (Heitz 2014, eq. 43).
[[nodiscard]] inline float smith_masking(const Vec3& v, float alpha) {
  return 1.0f / (1.0f + smith_lambda(v, alpha));
}

/// Part seen from both directions, heights correlated (Heitz 2014, eq. 99).
[[nodiscard]] inline float smith_masking_shadowing(const Vec3& a, const Vec3& b, float alpha) {
  return 1.0f / (1.0f + smith_lambda(a, alpha) + smith_lambda(b, alpha));
}

/// Draws a microfacet normal among those visible from v (v.z > 0) (Dupuy and Benyoub 2023,
/// "Sampling Visible GGX Normals with Spherical Caps", listing 3).
[[nodiscard]] inline Vec3 sample_visible_normal(const Vec3& v, float alpha, Vec2 random) {
  const Vec3 stretched = normalize(Vec3(v.x * alpha, v.y * alpha, v.z));
  const float phi = 2.0f * geometry::k_pi * random.x;
  const float z = (1.0f - random.y) * (1.0f + stretched.z) - stretched.z;
  const float sine = std::sqrt(std::clamp(1.0f - z * z, 0.0f, 1.0f));
  const Vec3 h = Vec3(sine * std::cos(phi), sine * std::sin(phi), z) + stretched;
  return normalize(Vec3(h.x * alpha, h.y * alpha, std::max(h.z, 1e-7f)));
}

/// Density of sample_visible_normal, per steradian of h (Heitz 2018, eq. 1).
[[nodiscard]] inline float visible_normal_pdf(const Vec3& v, const Vec3& h, float alpha) {
  return smith_masking(v, alpha) * std::max(0.0f, dot(v, h)) * ggx_distribution(h, alpha) / v.z;
}

}  // namespace lume::shading
