// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shading/color.h"

namespace lume::renderer {

using shading::Color;

/// The terms of the course's recursive model, each as it counts in the sum (nits).
struct LightTerms {
  Color emitted{0.0f};      ///< what the surface, or the backdrop, gives off itself
  Color ambient{0.0f};      ///< L_a k_a O_a
  Color diffuse{0.0f};      ///< sum over lights f_att L_p k_d O_d (n.l)
  Color specular{0.0f};     ///< sum over lights f_att L_p k_s O_s (r.v)^n
  Color reflected{0.0f};    ///< k_r O_s I_reflected
  Color transmitted{0.0f};  ///< k_t O_t I_transmitted

  /// I, added up in the order of the formula.
  [[nodiscard]] Color sum() const {
    return emitted + ambient + diffuse + specular + reflected + transmitted;
  }

  LightTerms& operator+=(const LightTerms& other) {
    emitted += other.emitted;
    ambient += other.ambient;
    diffuse += other.diffuse;
    specular += other.specular;
    reflected += other.reflected;
    transmitted += other.transmitted;
    return *this;
  }
  [[nodiscard]] friend LightTerms operator*(const Color& scale, const LightTerms& terms) {
    return {scale * terms.emitted,  scale * terms.ambient,   scale * terms.diffuse,
            scale * terms.specular, scale * terms.reflected, scale * terms.transmitted};
  }
};

/// What one ray brings back.
struct Radiance {
  LightTerms terms;    ///< of the surfaces it meets, weighted by their coverage
  Color shadow{0.0f};  ///< what diffuse and specular would be more if nothing cast a shadow
  float alpha = 0.0f;  ///< coverage: 0 where nothing was met and no backdrop shows
  int depth = 0;       ///< the most reflections and refractions in a row that were followed

  [[nodiscard]] Color color() const { return terms.sum(); }
};

}  // namespace lume::renderer
