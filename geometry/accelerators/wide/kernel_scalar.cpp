// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/wide/packet.h"
#include "geometry/accelerators/wide/simd_scalar.h"

namespace lume::geometry::wide {

const Kernel k_scalar_kernel = {"scalar",
                                KernelOf<Scalar>::closest,
                                KernelOf<Scalar>::any,
                                KernelOf<Scalar>::scene,
                                find_closest_of_packet<Scalar>,
                                find_any_of_packet<Scalar>};

}  // namespace lume::geometry::wide
