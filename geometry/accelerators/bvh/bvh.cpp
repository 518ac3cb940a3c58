// SPDX-License-Identifier: Apache-2.0
// The hierarchies of bounding volumes by their names: a volume and a builder each.
#include "geometry/accelerators/bvh/binned_sah.h"
#include "geometry/accelerators/bvh/box.h"
#include "geometry/accelerators/bvh/hierarchy.h"
#include "geometry/accelerators/bvh/median.h"
#include "geometry/accelerators/bvh/morton.h"
#include "geometry/accelerators/bvh/oriented_box.h"
#include "geometry/accelerators/bvh/reinsertion.h"
#include "geometry/accelerators/bvh/spatial_splits.h"
#include "geometry/accelerators/bvh/sphere.h"
#include "geometry/accelerators/bvh/sweep_sah.h"
#include "geometry/accelerators/registry.h"
#include "geometry/accelerators/two_level.h"

namespace lume::geometry {

std::unique_ptr<Accelerator> make_bvh_median(const World& world, const HoleTest* holes,
                                             const AcceleratorOptions& options) {
  return make_two_level<bvh::Hierarchy<bvh::Box, bvh::build_median>>(world, holes, options);
}

std::unique_ptr<Accelerator> make_bvh_sah(const World& world, const HoleTest* holes,
                                          const AcceleratorOptions& options) {
  return make_two_level<bvh::Hierarchy<bvh::Box, bvh::build_binned_sah>>(world, holes, options);
}

std::unique_ptr<Accelerator> make_bvh_sweep(const World& world, const HoleTest* holes,
                                            const AcceleratorOptions& options) {
  return make_two_level<bvh::Hierarchy<bvh::Box, bvh::build_sweep_sah>>(world, holes, options);
}

std::unique_ptr<Accelerator> make_bvh_lbvh(const World& world, const HoleTest* holes,
                                           const AcceleratorOptions& options) {
  return make_two_level<bvh::Hierarchy<bvh::Box, bvh::build_lbvh>>(world, holes, options);
}

std::unique_ptr<Accelerator> make_bvh_spatial(const World& world, const HoleTest* holes,
                                              const AcceleratorOptions& options) {
  return make_two_level<bvh::Hierarchy<bvh::Box, bvh::build_spatial_splits>>(world, holes, options);
}

std::unique_ptr<Accelerator> make_bvh_reinsert(const World& world, const HoleTest* holes,
                                               const AcceleratorOptions& options) {
  return make_two_level<bvh::Hierarchy<bvh::Box, bvh::build_reinserted>>(world, holes, options);
}

std::unique_ptr<Accelerator> make_sphere_tree(const World& world, const HoleTest* holes,
                                              const AcceleratorOptions& options) {
  return make_two_level<bvh::Hierarchy<bvh::BoundingSphere, bvh::build_binned_sah>>(world, holes,
                                                                                    options);
}

std::unique_ptr<Accelerator> make_obb_tree(const World& world, const HoleTest* holes,
                                           const AcceleratorOptions& options) {
  return make_two_level<bvh::Hierarchy<bvh::OrientedBox, bvh::build_binned_sah>>(world, holes,
                                                                                 options);
}

}  // namespace lume::geometry
