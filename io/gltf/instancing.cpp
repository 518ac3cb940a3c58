// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/instancing.h"

#include "io/gltf/accessors.h"
#include "io/gltf/nodes.h"

namespace lume::io::gltf {

using geometry::DMat3;
using geometry::DVec3;

InstancePlaces::InstancePlaces(const Document& document, const JsonView& node) {
  const std::optional<JsonView> extension = node.extension("EXT_mesh_gpu_instancing");
  if (!extension) {
    return;
  }
  const JsonView attributes = extension->require("attributes");
  for (const std::string& name : attributes.keys()) {
    const auto accessor = static_cast<std::size_t>(attributes.require(name).integer());
    size_ = document.model.accessors[accessor].count;
    if (name == "TRANSLATION") {
      translations_ = read_vec3(document, accessor);
    } else if (name == "ROTATION") {
      rotations_ = read_vec4(document, accessor);
    } else if (name == "SCALE") {
      scales_ = read_vec3(document, accessor);
    }
  }
}

geometry::DMat4 InstancePlaces::matrix(std::size_t instance) const {
  DMat3 rotation(1.0);
  if (!rotations_.empty()) {
    const geometry::Vec4& q = rotations_[instance];
    const bool has_direction = dot(q, q) > 0.0f;
    rotation =
        has_direction ? glm::mat3_cast(normalize(glm::dquat(q.w, q.x, q.y, q.z))) : DMat3(0.0);
  }
  return compose(translations_.empty() ? DVec3(0.0) : DVec3(translations_[instance]), rotation,
                 scales_.empty() ? DVec3(1.0) : DVec3(scales_[instance]));
}

}  // namespace lume::io::gltf
