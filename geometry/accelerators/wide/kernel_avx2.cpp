// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/wide/packet.h"
#include "geometry/accelerators/wide/simd_avx2.h"

namespace lume::geometry::wide {

const Kernel k_avx2_kernel = {"avx2",
                              KernelOf<Avx2>::closest,
                              KernelOf<Avx2>::any,
                              KernelOf<Avx2>::scene,
                              find_closest_of_packet<Avx2>,
                              find_any_of_packet<Avx2>};

}  // namespace lume::geometry::wide
