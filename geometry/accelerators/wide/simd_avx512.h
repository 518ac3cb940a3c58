// SPDX-License-Identifier: Apache-2.0
// The operations of kernel.h in AVX-512: as AVX2, with twice the registers and with masks of their
// own. Only for files that are compiled for it.
#pragma once

#include "geometry/accelerators/wide/simd_avx2.h"

namespace lume::geometry::wide {

struct Avx512 : Avx2 {
  [[gnu::always_inline]] static unsigned same_sign(Double4 a, Double4 b, Double4 c) {
    const __m256d zero = _mm256_setzero_pd();
    const __m256d low = _mm256_min_pd(_mm256_min_pd(a, b), c);
    const __m256d high = _mm256_max_pd(_mm256_max_pd(a, b), c);
    return static_cast<unsigned>(_mm256_cmp_pd_mask(low, zero, _CMP_GE_OQ) |
                                 _mm256_cmp_pd_mask(high, zero, _CMP_LE_OQ));
  }
  [[gnu::always_inline]] static unsigned not_zero(Double4 x) {
    return _mm256_cmp_pd_mask(x, _mm256_setzero_pd(), _CMP_NEQ_OQ);
  }
  [[gnu::always_inline]] static unsigned between(Double4 x, double low, double high) {
    return static_cast<unsigned>(_mm256_cmp_pd_mask(x, set(low), _CMP_GE_OQ) &
                                 _mm256_cmp_pd_mask(x, set(high), _CMP_LE_OQ));
  }
  [[gnu::always_inline]] static unsigned not_above(Float8 a, Float8 b) {
    return _mm256_cmp_ps_mask(a, b, _CMP_LE_OQ);
  }
};

}  // namespace lume::geometry::wide
