// SPDX-License-Identifier: Apache-2.0
// Which of the course's coefficients a metallic-roughness material stands for, so that both kinds
// can be read by one formula. Pictures are made with the material's own BSDF, of which this is the
// nearest description in the course's terms.
#pragma once

#include "shading/material_point.h"

namespace lume::shading {

/// The coefficients of a material at a point; its own if it has any. With b the base colour, m
/// metallic, t transmission, F0 the reflectance at normal incidence (KHR_materials_ior):
///   k_a O_a = k_d O_d = (1 - m) (1 - t) b        L_a reaches what is diffuse
///   k_s O_s = k_r O_s = (1 - m) F0 + m b         seen along the normal
///   k_t O_t = (1 - m) t b
///   n                                            (r.v)^n falls to half where the microfacets do
///   glossiness = n, or infinite                  below the roughness that counts as a mirror
/// and Fresnel's factors on.
[[nodiscard]] Phong equivalent_phong(const MaterialPoint& point);

/// The exponent n for which cos^n falls to a half at the angle at which, seen along the normal, the
/// slopes of GGX microfacets of width alpha do: their density, D(h) cos^4, is half of its peak
/// where tan^2(theta) = alpha^2 (sqrt(2) - 1), and the reflection turns by twice the angle.
[[nodiscard]] float equivalent_shininess(float alpha);

}  // namespace lume::shading
