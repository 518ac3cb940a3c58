// SPDX-License-Identifier: Apache-2.0
#include "renderer/sampler.h"

namespace lume::renderer {
namespace {

/// The finalizer of SplitMix64 (Steele, Lea, Flood 2014): every bit depends on every bit.
std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

std::uint64_t combine(std::uint64_t key, std::uint64_t value) { return mix(key ^ mix(value)); }

std::uint32_t reverse_bits(std::uint32_t x) {
  x = __builtin_bswap32(x);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
  x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
  return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

/// A hash in which each bit depends on the lower bits only: on reversed digits that is Owen's
/// nested uniform scramble (Laine and Karras 2011; constants by Vegdahl 2021).
std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

/// The second Sobol dimension with its digits reversed: the index times Pascal's triangle modulo 2.
/// By Lucas' theorem C(j, i) is odd where the bits of i are a subset of j's, so the product is a
/// sum over supersets, which takes one step for each bit of a position.
std::uint32_t sobol_second_reversed(std::uint32_t index) {
  index ^= (index >> 1) & 0x55555555u;
  index ^= (index >> 2) & 0x33333333u;
  index ^= (index >> 4) & 0x0f0f0f0fu;
  index ^= (index >> 8) & 0x00ff00ffu;
  index ^= (index >> 16) & 0x0000ffffu;
  return index;
}

/// The upper 24 bits as a float in [0, 1).
float to_unit(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

}  // namespace

Sampler::Sampler(std::uint64_t seed, int x, int y, std::uint32_t sample)
    : key_(combine(mix(seed), (static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32) |
                                  static_cast<std::uint32_t>(x))),
      sample_(sample) {}

Sampler Sampler::branch(std::uint32_t child) const {
  Sampler result = *this;
  result.key_ = combine(key_, 0x8000000000000000u | child);
  return result;
}

Vec2 Sampler::get_2d(std::uint32_t dimension) const {
  const std::uint64_t key = combine(key_, dimension);
  const auto shuffle = static_cast<std::uint32_t>(key);
  const auto scramble = static_cast<std::uint32_t>(key >> 32);
  const std::uint32_t index = reverse_bits(scramble_reversed(reverse_bits(sample_), shuffle));
  // The first dimension with its digits reversed is the index itself (van der Corput).
  const std::uint32_t x = scramble_reversed(index, scramble);
  const std::uint32_t y =
      scramble_reversed(sobol_second_reversed(index), static_cast<std::uint32_t>(mix(key)));
  return {to_unit(reverse_bits(x)), to_unit(reverse_bits(y))};
}

}  // namespace lume::renderer
