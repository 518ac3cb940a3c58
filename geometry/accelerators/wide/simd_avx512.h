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

  struct ManyFloats {
    static constexpr unsigned k_size = 16;

    [[gnu::always_inline]] static __m512 load(const float* x) { return _mm512_load_ps(x); }
    [[gnu::always_inline]] static __m512 fill(float x) { return _mm512_set1_ps(x); }
    [[gnu::always_inline]] static __m512 fma(__m512 a, __m512 b, __m512 c) {
      return _mm512_fmadd_ps(a, b, c);
    }
    [[gnu::always_inline]] static __m512 min(__m512 a, __m512 b) { return _mm512_min_ps(a, b); }
    [[gnu::always_inline]] static __m512 max(__m512 a, __m512 b) { return _mm512_max_ps(a, b); }
    [[gnu::always_inline]] static unsigned not_above(__m512 a, __m512 b) {
      return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ);
    }
  };

  struct ManyDoubles {
    static constexpr unsigned k_size = 8;

    [[gnu::always_inline]] static __m512d set(double x) { return _mm512_set1_pd(x); }
    [[gnu::always_inline]] static __m512d load(const double* x) { return _mm512_load_pd(x); }
    [[gnu::always_inline]] static void store(double* to, __m512d x) { _mm512_store_pd(to, x); }
    [[gnu::always_inline]] static __m512d add(__m512d a, __m512d b) { return _mm512_add_pd(a, b); }
    [[gnu::always_inline]] static __m512d sub(__m512d a, __m512d b) { return _mm512_sub_pd(a, b); }
    [[gnu::always_inline]] static __m512d mul(__m512d a, __m512d b) { return _mm512_mul_pd(a, b); }
    [[gnu::always_inline]] static __m512d div(__m512d a, __m512d b) { return _mm512_div_pd(a, b); }
    [[gnu::always_inline]] static unsigned same_sign(__m512d a, __m512d b, __m512d c) {
      const __m512d zero = _mm512_setzero_pd();
      const __m512d low = _mm512_min_pd(_mm512_min_pd(a, b), c);
      const __m512d high = _mm512_max_pd(_mm512_max_pd(a, b), c);
      return static_cast<unsigned>(_mm512_cmp_pd_mask(low, zero, _CMP_GE_OQ) |
                                   _mm512_cmp_pd_mask(high, zero, _CMP_LE_OQ));
    }
    [[gnu::always_inline]] static unsigned not_zero(__m512d x) {
      return _mm512_cmp_pd_mask(x, _mm512_setzero_pd(), _CMP_NEQ_OQ);
    }
  };
};

}  // namespace lume::geometry::wide
