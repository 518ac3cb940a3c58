// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/meshopt_color.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace lume::io::gltf {
namespace {

/// R = Y + Co - Cg, G = Y + Cg, B = Y - Co - Cg, in K bits. Above alpha's K - 1 bits stands a one,
/// which tells K. What no encoder may write (sums below 0 or beyond the largest) is clamped.
template <class Unsigned>
void decode_colors(std::byte* data, std::size_t count) {
  using Signed = std::make_signed_t<Unsigned>;
  constexpr int k_largest = std::numeric_limits<Unsigned>::max();
  for (std::size_t i = 0; i < count; ++i, data += 4 * sizeof(Unsigned)) {
    std::array<Unsigned, 4> in{};
    std::memcpy(in.data(), data, sizeof(in));
    const int y = in[0];
    const int co = static_cast<Signed>(in[1]);
    const int cg = static_cast<Signed>(in[2]);
    const int all_ones = static_cast<int>((1u << std::bit_width(in[3])) - 1u);
    const int alpha = in[3] & (all_ones >> 1);
    const std::array<int, 4> rgba = {y + co - cg, y + cg, y - co - cg, (alpha << 1) | (alpha & 1)};
    std::array<Unsigned, 4> out{};
    for (std::size_t c = 0; c < 4 && all_ones > 0; ++c) {
      const float scaled = static_cast<float>(rgba[c]) *
                           (static_cast<float>(k_largest) / static_cast<float>(all_ones));
      out[c] = static_cast<Unsigned>(
          std::clamp(std::round(scaled), 0.0f, static_cast<float>(k_largest)));
    }
    std::memcpy(data, out.data(), sizeof(out));
  }
}

}  // namespace

void decode_meshopt_colors(std::byte* data, std::size_t count, std::size_t stride) {
  if (stride == 4) {
    decode_colors<std::uint8_t>(data, count);
  } else {
    decode_colors<std::uint16_t>(data, count);
  }
}

}  // namespace lume::io::gltf
