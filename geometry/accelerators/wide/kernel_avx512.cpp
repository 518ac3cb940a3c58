// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/wide/packet.h"
#include "geometry/accelerators/wide/simd_avx512.h"

namespace lume::geometry::wide {

const Kernel k_avx512_kernel = {"avx512",
                                KernelOf<Avx512>::closest,
                                KernelOf<Avx512>::any,
                                KernelOf<Avx512>::scene,
                                find_closest_of_packet<Avx512>,
                                find_any_of_packet<Avx512>};

}  // namespace lume::geometry::wide
