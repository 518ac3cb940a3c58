// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/wide/query.h"

#include <cstdlib>
#include <string_view>

namespace lume::geometry::wide {
namespace {

bool has_avx2() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
         __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
}

bool has_avx512() {
  return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
}

const Kernel& choose_kernel() {
  const char* const wish = std::getenv("LUME_WIDE_KERNEL");
  const std::string_view name = wish == nullptr ? "" : wish;
  const bool any = name != k_avx2_kernel.name && name != k_scalar_kernel.name;
  if (any && can_run(k_avx512_kernel)) return k_avx512_kernel;
  if (name != k_scalar_kernel.name && can_run(k_avx2_kernel)) return k_avx2_kernel;
  return k_scalar_kernel;
}

}  // namespace

bool can_run(const Kernel& kernel) {
  __builtin_cpu_init();
  if (&kernel == &k_avx512_kernel) return has_avx512();
  return &kernel == &k_scalar_kernel || has_avx2();
}

const Kernel& best_kernel() {
  static const Kernel& kernel = choose_kernel();
  return kernel;
}

}  // namespace lume::geometry::wide
