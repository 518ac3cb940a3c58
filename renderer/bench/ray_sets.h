// SPDX-License-Identifier: Apache-2.0
// The rays by which structures are compared. They are those of real pictures, recorded once, so
// that every structure answers the same questions.
#pragma once

#include "geometry/camera.h"
#include "geometry/ray.h"
#include "renderer/prepared_scene.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lume::renderer {

enum class RaySetKind { primary, shadow, diffuse, bounce2, ao };

struct RaySetInfo {
  RaySetKind kind;
  std::string_view name;         ///< on the command line
  bool any_hit;                  ///< asked is whether anything is met, not what comes first
  bool coherent;                 ///< each run of k_batch_size rays runs much alike
  std::string_view description;  ///< a few words
};

/// All kinds, in the order of the enumeration.
[[nodiscard]] std::span<const RaySetInfo> ray_set_infos();

/// How many coherent rays are shot together: a block of 4x4 pixels.
inline constexpr std::size_t k_batch_size = 16;

struct RaySet {
  std::string name;
  bool any_hit = false;
  bool coherent = false;
  std::vector<geometry::Ray> rays;  ///< in the scene's frame
};

struct RaySetSettings {
  std::size_t count = std::size_t{1} << 18;  ///< rays of each kind
  int width = 1280;                          ///< pixels of the picture whose rays they are
  int height = 720;
  std::uint64_t seed = 0;
  float ao_distance = 0.0f;  ///< where rays of the kind `ao` end (metres); 0: a tenth of the scene
};

/// The scene's rays as the camera's picture would shoot them. Every set has settings.count rays,
/// unless the camera sees nothing (then those from surfaces are empty) or no surface faces a light.
/// They depend on the scene and the settings only, if the structure in `prepared` is right.
[[nodiscard]] std::vector<RaySet> record_rays(const PreparedScene& prepared,
                                              const geometry::Camera& camera,
                                              const RaySetSettings& settings,
                                              std::span<const RaySetKind> kinds);

}  // namespace lume::renderer
