// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>

namespace lume::geometry {

/// The identity of what a ray meets, and all that an accelerator reports: where exactly it is met
/// follows from the identity alone (refine.h), so every accelerator gives the same picture.
struct Hit {
  std::uint32_t instance = 0;   ///< index into World::instances
  std::uint32_t geometry = 0;   ///< index into Object::geometries
  std::uint32_t primitive = 0;  ///< index into Mesh::triangles; of a shape its Crossing::part

  auto operator<=>(const Hit&) const = default;  // NOLINT(modernize-use-nullptr): tidy 14 errs
};

}  // namespace lume::geometry
