// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/wide/simd_scalar.h"

namespace lume::geometry::wide {

const Kernel k_scalar_kernel = {"scalar", KernelOf<Scalar>::closest, KernelOf<Scalar>::any,
                                KernelOf<Scalar>::scene};

}  // namespace lume::geometry::wide
