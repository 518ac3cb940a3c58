// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/wide/simd_avx512.h"

namespace lume::geometry::wide {

const Kernel k_avx512_kernel = {"avx512", KernelOf<Avx512>::closest, KernelOf<Avx512>::any,
                                KernelOf<Avx512>::scene};

}  // namespace lume::geometry::wide
