// SPDX-License-Identifier: Apache-2.0
// Every structure that has a name. To add one: its file, and one line here.
#pragma once

#include "geometry/accelerators/accelerator.h"

#include <array>

namespace lume::geometry {

/// Builds a structure over the world; `holes` may be null. World and holes outlive the result.
using MakeAccelerator = std::unique_ptr<Accelerator>(const World&, const HoleTest* holes,
                                                     const AcceleratorOptions&);

// One function a structure, in the file of its name.
MakeAccelerator make_embree;
MakeAccelerator make_embree_high;
MakeAccelerator make_wide;
MakeAccelerator make_bvh_median;
MakeAccelerator make_bvh_sah;
MakeAccelerator make_bvh_sweep;
MakeAccelerator make_bvh_lbvh;
MakeAccelerator make_bvh_spatial;
MakeAccelerator make_bvh_reinsert;
MakeAccelerator make_sphere_tree;
MakeAccelerator make_obb_tree;
MakeAccelerator make_grid;
MakeAccelerator make_octree;
MakeAccelerator make_kd_tree;
MakeAccelerator make_zbuffer;
MakeAccelerator make_brute_force;

struct AcceleratorEntry {
  std::string_view name;
  MakeAccelerator* make;
};

/// The default first.
inline constexpr std::array k_registry = {
    AcceleratorEntry{"wide", make_wide},
    AcceleratorEntry{"embree", make_embree},
    AcceleratorEntry{"embree-high", make_embree_high},
    AcceleratorEntry{"bvh-median", make_bvh_median},
    AcceleratorEntry{"bvh-sah", make_bvh_sah},
    AcceleratorEntry{"bvh-sweep", make_bvh_sweep},
    AcceleratorEntry{"bvh-lbvh", make_bvh_lbvh},
    AcceleratorEntry{"bvh-spatial", make_bvh_spatial},
    AcceleratorEntry{"bvh-reinsert", make_bvh_reinsert},
    AcceleratorEntry{"sphere-tree", make_sphere_tree},
    AcceleratorEntry{"obb-tree", make_obb_tree},
    AcceleratorEntry{"grid", make_grid},
    AcceleratorEntry{"octree", make_octree},
    AcceleratorEntry{"kd-tree", make_kd_tree},
    AcceleratorEntry{"zbuffer", make_zbuffer},
    AcceleratorEntry{"brute-force", make_brute_force},
};

}  // namespace lume::geometry
