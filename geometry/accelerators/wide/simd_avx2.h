// SPDX-License-Identifier: Apache-2.0
// The operations of kernel.h in AVX2 with FMA. Only for files that are compiled for it.
#pragma once

#include "geometry/accelerators/wide/kernel.h"

#include <immintrin.h>

namespace lume::geometry::wide {

struct Avx2 {
  using Double4 = __m256d;

  [[gnu::always_inline]] static Double4 set(double x) { return _mm256_set1_pd(x); }
  [[gnu::always_inline]] static Double4 widen(const float* x) {
    return _mm256_cvtps_pd(_mm_load_ps(x));
  }
  [[gnu::always_inline]] static Double4 load(const double* x) { return _mm256_load_pd(x); }
  [[gnu::always_inline]] static void store(double* to, Double4 x) { _mm256_store_pd(to, x); }
  [[gnu::always_inline]] static Double4 add(Double4 a, Double4 b) { return _mm256_add_pd(a, b); }
  [[gnu::always_inline]] static Double4 sub(Double4 a, Double4 b) { return _mm256_sub_pd(a, b); }
  [[gnu::always_inline]] static Double4 mul(Double4 a, Double4 b) { return _mm256_mul_pd(a, b); }
  [[gnu::always_inline]] static Double4 div(Double4 a, Double4 b) { return _mm256_div_pd(a, b); }

  [[gnu::always_inline]] static unsigned mask_of(__m256d x) {
    return static_cast<unsigned>(_mm256_movemask_pd(x));
  }
  /// Where no two of three numbers have different signs; zeros have none.
  [[gnu::always_inline]] static unsigned same_sign(Double4 a, Double4 b, Double4 c) {
    const __m256d zero = _mm256_setzero_pd();
    const __m256d low = _mm256_min_pd(_mm256_min_pd(a, b), c);
    const __m256d high = _mm256_max_pd(_mm256_max_pd(a, b), c);
    return mask_of(
        _mm256_or_pd(_mm256_cmp_pd(low, zero, _CMP_GE_OQ), _mm256_cmp_pd(high, zero, _CMP_LE_OQ)));
  }
  [[gnu::always_inline]] static unsigned not_zero(Double4 x) {
    return mask_of(_mm256_cmp_pd(x, _mm256_setzero_pd(), _CMP_NEQ_OQ));
  }
  [[gnu::always_inline]] static unsigned between(Double4 x, double low, double high) {
    return mask_of(_mm256_and_pd(_mm256_cmp_pd(x, set(low), _CMP_GE_OQ),
                                 _mm256_cmp_pd(x, set(high), _CMP_LE_OQ)));
  }

  [[gnu::always_inline]] static void prepare(const TreeRay& ray, const float (&farthest)[4],
                                             Reciprocal& result) {
    const double dx = std::fabs(ray.direction[0]);
    const double dy = std::fabs(ray.direction[1]);
    const double dz = std::fabs(ray.direction[2]);
    const double dxy = dx > dy ? dx : dy;
    result.scale = dxy > dz ? dxy : dz;
    const __m256d sign = set(-0.0);
    // Number by number: they were just written one at a time, and a load of all would wait for
    // that.
    const __m256d origin = _mm256_setr_pd(ray.origin[0], ray.origin[1], ray.origin[2], 0.0);
    const __m256d direction =
        _mm256_setr_pd(ray.direction[0], ray.direction[1], ray.direction[2], 1.0);
    const __m256d d = div(direction, set(result.scale));
    const __m256d steep = _mm256_max_pd(_mm256_andnot_pd(sign, d), set(Reciprocal::k_flattest));
    const __m256d size = add(_mm256_andnot_pd(sign, origin), widen(farthest));
    const __m256d inverse_size = div(set(1.0), steep);
    const __m256d inverse = _mm256_or_pd(inverse_size, _mm256_and_pd(sign, d));
    const __m256d slack = mul(mul(set(Reciprocal::k_rounding), size), inverse_size);
    const __m256d offset = mul(_mm256_xor_pd(sign, origin), inverse);
    _mm_store_ps(result.inverse, _mm256_cvtpd_ps(inverse));
    _mm_store_ps(result.near_offset, _mm256_cvtpd_ps(sub(offset, slack)));
    _mm_store_ps(result.far_offset, _mm256_cvtpd_ps(add(offset, slack)));
  }

  using Float8 = __m256;

  [[gnu::always_inline]] static Float8 fill(float x) { return _mm256_set1_ps(x); }
  [[gnu::always_inline]] static Float8 load(const float* x) { return _mm256_load_ps(x); }
  [[gnu::always_inline]] static Float8 add(Float8 a, Float8 b) { return _mm256_add_ps(a, b); }
  [[gnu::always_inline]] static Float8 mul(Float8 a, Float8 b) { return _mm256_mul_ps(a, b); }
  [[gnu::always_inline]] static Float8 fma(Float8 a, Float8 b, Float8 c) {
    return _mm256_fmadd_ps(a, b, c);
  }
  [[gnu::always_inline]] static Float8 min(Float8 a, Float8 b) { return _mm256_min_ps(a, b); }
  [[gnu::always_inline]] static Float8 max(Float8 a, Float8 b) { return _mm256_max_ps(a, b); }
  [[gnu::always_inline]] static void store(float* to, Float8 x) { _mm256_store_ps(to, x); }
  [[gnu::always_inline]] static unsigned not_above(Float8 a, Float8 b) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LE_OQ)));
  }

  /// For packets: as many at once as a register holds.
  struct ManyFloats;
  struct ManyDoubles;
};

struct Avx2::ManyFloats : Avx2 {
  static constexpr unsigned k_size = 8;
};
struct Avx2::ManyDoubles : Avx2 {
  static constexpr unsigned k_size = 4;
};

}  // namespace lume::geometry::wide
