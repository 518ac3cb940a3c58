// SPDX-License-Identifier: Apache-2.0
// The numbers of a scene that `lume info` reports in both of its forms.
#pragma once

#include "io/gltf/load_gltf.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lume::cli {

/// One watt of light at 555 nm is 683 lumens (SI definition of the candela), so X cd are X / 683
/// W/sr and X lx are X / 683 W/m^2.
inline constexpr double k_lumens_per_watt = 683.0;

struct SceneCounts {
  std::uint64_t primitives = 0;           ///< of all meshes, each with one material
  std::uint64_t triangles = 0;            ///< each mesh counted once
  std::uint64_t triangles_instanced = 0;  ///< as often as it is placed
  std::uint64_t vertices = 0;
  std::uint64_t shapes = 0;            ///< analytic surfaces, each counted once
  std::uint64_t shapes_instanced = 0;  ///< as often as they are placed

  std::uint64_t mesh_bytes = 0;
  std::uint64_t image_bytes = 0;        ///< decoded
  std::uint64_t accelerator_bytes = 0;  ///< a guess from the number of triangles
  [[nodiscard]] std::uint64_t total_bytes() const {
    return mesh_bytes + image_bytes + accelerator_bytes;
  }
};

[[nodiscard]] SceneCounts count_scene(const shading::Scene& scene);

/// Memory that the image takes once its texels are decoded.
[[nodiscard]] std::uint64_t decoded_bytes(const shading::Image& image);

/// A box in the world.
struct WorldBounds {
  geometry::DVec3 lower{0.0};
  geometry::DVec3 upper{0.0};
};
/// Nothing for a scene without geometry.
[[nodiscard]] std::optional<WorldBounds> world_bounds(const shading::Scene& scene);

/// What is special about a material, a few words each ("base color texture", "transmission 0.9").
[[nodiscard]] std::vector<std::string> material_features(const shading::Material& material);

[[nodiscard]] std::string_view kind_name(shading::PunctualLight::Kind kind);
/// "cd" or "lx".
[[nodiscard]] std::string_view light_unit(shading::PunctualLight::Kind kind);
[[nodiscard]] std::string_view support_name(io::Support support);

}  // namespace lume::cli
