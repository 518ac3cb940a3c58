// SPDX-License-Identifier: Apache-2.0
// What the notes of a ray tree leave to be looked up: names, coefficients, angles, colours of
// lines.
#pragma once

#include "renderer/ray_tree.h"
#include "shading/material_point.h"
#include "shading/scene.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace lume::cli {

/// Of the node, or of its mesh, or "object N".
[[nodiscard]] std::string object_name(const shading::Scene& scene, const geometry::Hit& hit);
/// Or "material N".
[[nodiscard]] std::string material_name(const shading::Scene& scene, const geometry::Hit& hit);
[[nodiscard]] std::string light_name(const shading::Scene& scene, const renderer::LightNote& light);

/// The factors of the formula at a surface.
struct Coefficients {
  shading::MaterialPoint point;
  shading::Phong phong;
  bool equivalent = false;  ///< the material is of another model, to which these come nearest

  [[nodiscard]] shading::Color ambient() const;       ///< k_a O_a
  [[nodiscard]] shading::Color diffuse() const;       ///< k_d O_d
  [[nodiscard]] shading::Color specular() const;      ///< k_s O_s
  [[nodiscard]] shading::Color reflection() const;    ///< k_r O_s
  [[nodiscard]] shading::Color transmission() const;  ///< k_t O_t
};

[[nodiscard]] Coefficients coefficients_at(const shading::Scene& scene,
                                           const renderer::RayNote& ray,
                                           const renderer::SurfaceNote& surface);

/// Metres along the ray from its origin. SurfacePoint::t is that of the first surface only.
[[nodiscard]] float distance_to(const renderer::RayNote& ray, const renderer::SurfaceNote& surface);

/// Unit, from the surface.
[[nodiscard]] geometry::Vec3 direction_to_light(const renderer::LightNote& light,
                                                const geometry::SurfacePoint& point);
/// Where the light is; none if infinitely far away.
[[nodiscard]] std::optional<geometry::Vec3> light_position(const renderer::LightNote& light);
[[nodiscard]] bool is_blocked(const renderer::LightNote& light);

/// True if the ray left the scene, whether or not it saw a backdrop there.
[[nodiscard]] bool leaves_scene(const shading::Scene& scene, const renderer::RayNote& ray);

[[nodiscard]] std::string_view name_of(renderer::RayKind kind);

/// How rays are shown wherever they are drawn: those that RayKind has, then shadow rays.
struct RayLook {
  std::string_view name;
  std::array<std::uint8_t, 3> srgb;
};
inline constexpr std::array<RayLook, 5> k_ray_looks = {{{"camera ray", {176, 96, 160}},
                                                        {"reflection ray", {0, 114, 178}},
                                                        {"refraction ray", {0, 148, 110}},
                                                        {"shadow ray", {230, 159, 0}},
                                                        {"shadow ray, blocked", {200, 16, 30}}}};
[[nodiscard]] const RayLook& look_of(renderer::RayKind kind);
[[nodiscard]] const RayLook& look_of(const renderer::LightNote& light);

}  // namespace lume::cli
