// SPDX-License-Identifier: Apache-2.0
// An encoder of meshoptimizer's vertex codec of version 1, which Debian's library does not have. It
// chooses among all that the format allows at random, so that a decoder meets all of it.
#pragma once

#include "tests/support/random.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace lume::test {

namespace meshopt_v1 {

using Stream = std::vector<std::uint8_t>;

template <class T>
T zigzag(T v) {
  const bool is_negative = (v >> (8 * sizeof(T) - 1)) != 0;
  const auto twice = static_cast<T>(v << 1);
  return is_negative ? static_cast<T>(~twice) : twice;
}

/// The four bytes that stand for `now` after `before`.
inline std::uint32_t delta(std::uint32_t before, std::uint32_t now, unsigned mode) {
  if (mode % 16 == 2) {
    const std::uint32_t difference = before ^ now;
    const unsigned turn = mode / 16;
    return turn == 0 ? difference : (difference >> turn) | (difference << (32 - turn));
  }
  std::uint32_t result = 0;
  for (unsigned shift = 0; shift < 32; shift += mode == 1 ? 16 : 8) {
    const std::uint32_t difference = (now >> shift) - (before >> shift);
    result |= (mode == 1 ? std::uint32_t{zigzag(static_cast<std::uint16_t>(difference))}
                         : std::uint32_t{zigzag(static_cast<std::uint8_t>(difference))})
              << shift;
  }
  return result;
}

/// Sixteen deltas in `bits` bits each, whole bytes for those that do not fit behind them.
inline void put_group(Stream& out, const std::uint8_t* deltas, unsigned bits) {
  const unsigned ones = (1u << bits) - 1u;
  Stream beyond;
  for (unsigned i = 0; bits > 0 && i < 16; i += 8 / bits) {
    unsigned packed = 0;
    for (unsigned k = 0; k < 8 / bits; ++k) {
      const bool fits = bits == 8 || deltas[i + k] < ones;
      if (!fits) beyond.push_back(deltas[i + k]);
      const unsigned place = bits == 1 ? k : 8 / bits - 1 - k;
      packed |= (fits ? deltas[i + k] : ones) << (place * bits);
    }
    out.push_back(static_cast<std::uint8_t>(packed));
  }
  out.insert(out.end(), beyond.begin(), beyond.end());
}

/// The deltas of one byte place; returns the control mode used.
inline unsigned put_plane(Stream& out, const Stream& deltas, Random& random) {
  const bool is_zero = std::all_of(deltas.begin(), deltas.end(), [](auto d) { return d == 0; });
  const unsigned control = is_zero ? 2 : std::array{0u, 1u, 3u}[random.below(3)];
  if (control == 2) return control;
  if (control == 3) {
    out.insert(out.end(), deltas.begin(), deltas.end());
    return control;
  }
  Stream padded = deltas;
  padded.resize((deltas.size() + 15) / 16 * 16);
  constexpr unsigned k_bits[2][4] = {{0, 1, 2, 4}, {1, 2, 4, 8}};
  Stream groups;
  Stream header((padded.size() / 16 + 3) / 4);
  for (std::size_t g = 0; g < padded.size() / 16; ++g) {
    const std::uint8_t* first = padded.data() + 16 * g;
    unsigned width = random.below(4);
    if (k_bits[control][width] == 0 && std::any_of(first, first + 16, [](auto d) { return d; })) {
      width = 3;
    }
    header[g / 4] = static_cast<std::uint8_t>(header[g / 4] | width << (2 * (g % 4)));
    put_group(groups, first, k_bits[control][width]);
  }
  out.insert(out.end(), header.begin(), header.end());
  out.insert(out.end(), groups.begin(), groups.end());
  return control;
}

inline std::uint32_t load(const Stream& data, std::size_t at) {
  return data[at] | data[at + 1] << 8 | data[at + 2] << 16 |
         static_cast<std::uint32_t>(data[at + 3]) << 24;
}

}  // namespace meshopt_v1

/// `data` holds elements of `stride` bytes (KHR_meshopt_compression, appendix A, mode 0).
inline std::vector<std::uint8_t> encode_meshopt_v1(const std::vector<std::uint8_t>& data,
                                                   std::size_t stride, Random& random) {
  using namespace meshopt_v1;
  Stream out = {0xA1};
  Stream tail(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(stride));
  for (std::size_t c = 0; c < stride / 4; ++c) {
    const std::uint32_t mode = random.below(3);
    tail.push_back(static_cast<std::uint8_t>(mode == 2 ? 2 + 16 * random.below(16) : mode));
  }
  const std::size_t block = std::min<std::size_t>(8192 / stride / 16 * 16, 256);
  const std::size_t count = data.size() / stride;
  for (std::size_t start = 0; start < count; start += block) {
    Stream controls(stride / 4);
    Stream planes;
    for (std::size_t byte = 0; byte < stride; ++byte) {
      const std::size_t channel = byte / 4 * 4;
      Stream deltas;
      for (std::size_t i = start; i < std::min(count, start + block); ++i) {
        const std::uint32_t before = load(data, (i == 0 ? 0 : i - 1) * stride + channel);
        const std::uint32_t d =
            delta(before, load(data, i * stride + channel), tail[stride + byte / 4]);
        deltas.push_back(static_cast<std::uint8_t>(d >> (8 * (byte % 4))));
      }
      controls[byte / 4] = static_cast<std::uint8_t>(
          controls[byte / 4] | put_plane(planes, deltas, random) << (2 * (byte % 4)));
    }
    out.insert(out.end(), controls.begin(), controls.end());
    out.insert(out.end(), planes.begin(), planes.end());
  }
  out.resize(out.size() + (tail.size() < 24 ? 24 - tail.size() : 0));
  out.insert(out.end(), tail.begin(), tail.end());
  return out;
}

}  // namespace lume::test
