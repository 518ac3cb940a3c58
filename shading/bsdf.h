// SPDX-License-Identifier: Apache-2.0
// What a surface does with light, whichever way its material is described: glTF's (gltf_bsdf.h) or
// the course's (phong_bsdf.h). Both offer the terms of the recursive model; docs/phong.md says
// which quantity of the one stands for which of the other.
#pragma once

#include "shading/gltf_bsdf.h"
#include "shading/phong_bsdf.h"

#include <optional>
#include <variant>

namespace lume::shading {

class Bsdf {
 public:
  /// `inside`: the viewer is inside the solid that the surface bounds.
  Bsdf(const MaterialPoint& point, const Vec3& to_viewer, bool inside)
      : model_(point.material->phong ? Model(PhongBsdf(point, to_viewer, inside))
                                     : Model(GltfBsdf(point, to_viewer, inside))) {}

  /// Part of even light from all around that the diffuse part returns to the viewer.
  [[nodiscard]] Color ambient() const {
    return std::visit([](const auto& model) { return model.ambient(); }, model_);
  }
  /// False where eval_diffuse and eval_specular are 0 for all directions.
  [[nodiscard]] bool scatters() const {
    return std::visit([](const auto& model) { return model.scatters(); }, model_);
  }
  /// BRDF times the cosine (1/sr); 0 below the surface.
  [[nodiscard]] Color eval_diffuse(const Vec3& to_light) const {
    return std::visit([&](const auto& model) { return model.eval_diffuse(to_light); }, model_);
  }
  /// The same of the highlight; 0 for a mirror.
  [[nodiscard]] Color eval_specular(const Vec3& to_light) const {
    return std::visit([&](const auto& model) { return model.eval_specular(to_light); }, model_);
  }
  /// The density with which sample_reflection() returns a direction, where reflected rays look for
  /// the same light as eval_specular; 0 for a mirror, and where highlights are a term of their own.
  [[nodiscard]] float reflection_pdf(const Vec3& to_light) const {
    const auto* gltf = std::get_if<GltfBsdf>(&model_);
    return gltf != nullptr ? gltf->reflection_pdf(to_light) : 0.0f;
  }

  /// Sampling needs no random numbers: all the light goes one way.
  [[nodiscard]] bool reflects_sharply() const {
    return std::visit([](const auto& model) { return model.reflects_sharply(); }, model_);
  }
  [[nodiscard]] bool transmits_sharply() const {
    const auto* gltf = std::get_if<GltfBsdf>(&model_);
    return gltf == nullptr || gltf->reflects_sharply();
  }

  /// Where a reflected ray goes; none when the direction drawn leads into the surface.
  [[nodiscard]] std::optional<LobeSample> sample_reflection(Vec2 random) const {
    return std::visit([&](const auto& model) { return model.sample_reflection(random); }, model_);
  }
  /// Where a transmitted ray goes; none where nothing is transmitted.
  [[nodiscard]] std::optional<LobeSample> sample_transmission(Vec2 random) const {
    const auto* gltf = std::get_if<GltfBsdf>(&model_);
    return gltf != nullptr ? gltf->sample_transmission(random)
                           : std::get<PhongBsdf>(model_).sample_transmission();
  }

  [[nodiscard]] bool has_diffuse() const {
    return std::visit([](const auto& model) { return model.has_diffuse(); }, model_);
  }
  /// About what a reflected and a transmitted ray count for, to decide if they are worth tracing.
  [[nodiscard]] Color reflection_color() const {
    return std::visit([](const auto& model) { return model.reflection_color(); }, model_);
  }
  [[nodiscard]] Color transmission_color() const {
    return std::visit([](const auto& model) { return Color(model.transmission_color()); }, model_);
  }

 private:
  using Model = std::variant<GltfBsdf, PhongBsdf>;
  Model model_;
};

/// Part of the light that goes straight through a surface: what a shadow ray keeps. `cosine` is
/// that of the angle with the normal.
[[nodiscard]] inline Color straight_transmittance(const MaterialPoint& point, float cosine) {
  return point.material->phong ? phong_straight_transmittance(point, cosine)
                               : gltf_straight_transmittance(point, cosine);
}

}  // namespace lume::shading
