// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/meshopt_v1.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace lume::io::gltf {
namespace {

constexpr std::size_t k_group = 16;        ///< elements that share a width
constexpr std::size_t k_most_block = 256;  ///< elements of a block
constexpr std::size_t k_least_tail = 24;   ///< bytes, padded in front

/// How the bytes at one place of all elements of a block are stored.
enum class Control : unsigned { narrow, wide, zero, literal };

/// Reads forward; once it would leave its bytes it stays broken and gives zeros.
class Reader {
 public:
  explicit Reader(Bytes bytes) : bytes_(bytes) {}

  std::uint8_t next() {
    if (at_ == bytes_.size()) {
      is_broken_ = true;
      return 0;
    }
    return std::to_integer<std::uint8_t>(bytes_[at_++]);
  }
  [[nodiscard]] bool is_broken() const { return is_broken_; }
  [[nodiscard]] bool is_at_end() const { return at_ == bytes_.size(); }

 private:
  Bytes bytes_;
  std::size_t at_ = 0;
  bool is_broken_ = false;
};

/// 16 deltas of `bits` bits. All ones stand for a whole byte behind the group. Pairs of bits and
/// half bytes begin with the highest, single bits with the lowest.
void read_group(Reader& reader, unsigned bits, std::uint8_t* deltas) {
  if (bits == 0) {
    std::fill_n(deltas, k_group, std::uint8_t{0});
    return;
  }
  const unsigned per_byte = 8 / bits;
  const unsigned all_ones = (1u << bits) - 1u;
  for (std::size_t i = 0; i < k_group; i += per_byte) {
    const unsigned packed = reader.next();
    for (unsigned k = 0; k < per_byte; ++k) {
      const unsigned place = bits == 1 ? k : per_byte - 1 - k;
      deltas[i + k] = static_cast<std::uint8_t>((packed >> (place * bits)) & all_ones);
    }
  }
  if (bits == 8) {
    return;
  }
  for (std::size_t i = 0; i < k_group; ++i) {
    if (deltas[i] == all_ones) {
      deltas[i] = reader.next();
    }
  }
}

/// The deltas of one byte of `count` elements; room for whole groups is behind `deltas`.
void read_plane(Reader& reader, Control control, std::size_t count, std::uint8_t* deltas) {
  if (control == Control::zero) {
    std::fill_n(deltas, count, std::uint8_t{0});
    return;
  }
  if (control == Control::literal) {
    std::generate_n(deltas, count, [&] { return reader.next(); });
    return;
  }
  constexpr std::array<std::array<unsigned, 4>, 2> k_bits = {{{0, 1, 2, 4}, {1, 2, 4, 8}}};
  const auto& bits = k_bits[static_cast<std::size_t>(control)];
  const std::size_t groups = (count + k_group - 1) / k_group;
  std::array<unsigned, k_most_block / k_group> widths{};
  unsigned packed = 0;
  for (std::size_t g = 0; g < groups; ++g) {
    packed = g % 4 == 0 ? reader.next() : packed >> 2;
    widths[g] = bits[packed & 3u];
  }
  for (std::size_t g = 0; g < groups; ++g) {
    read_group(reader, widths[g], deltas + g * k_group);
  }
}

/// 0, -1, 1, -2 ... from 0, 1, 2, 3 ...
template <class T>
T unzigzag(T value) {
  return static_cast<T>((value & 1u) != 0 ? ~(value >> 1) : value >> 1);
}

/// The four bytes after `last`, whose deltas are packed in `delta` from the lowest byte on.
std::uint32_t next_channel(std::uint32_t last, std::uint32_t delta, unsigned mode) {
  if ((mode & 15u) == 2) {
    const unsigned turn = mode >> 4;
    return last ^ ((delta << turn) | (delta >> ((32 - turn) & 31u)));
  }
  std::uint32_t result = 0;
  const unsigned width = mode == 1 ? 16 : 8;
  const std::uint32_t mask = (1u << width) - 1u;
  for (unsigned shift = 0; shift < 32; shift += width) {
    const std::uint32_t part = (delta >> shift) & mask;
    const std::uint32_t step = mode == 1 ? unzigzag(static_cast<std::uint16_t>(part))
                                         : unzigzag(static_cast<std::uint8_t>(part));
    result |= ((((last >> shift) & mask) + step) & mask) << shift;
  }
  return result;
}

struct Tail {
  std::vector<std::uint32_t> last;  ///< by channel of four bytes, little-endian
  std::vector<unsigned> modes;
};

std::uint32_t load(const std::uint8_t* bytes, std::size_t step) {
  return bytes[0] | std::uint32_t{bytes[step]} << 8 | std::uint32_t{bytes[2 * step]} << 16 |
         std::uint32_t{bytes[3 * step]} << 24;
}

/// False for modes that there are not.
bool read_tail(Bytes bytes, std::size_t stride, Tail& tail) {
  Reader reader(bytes);
  std::array<std::uint8_t, 256> first{};
  std::generate_n(first.begin(), stride, [&] { return reader.next(); });
  for (std::size_t channel = 0; channel < stride / 4; ++channel) {
    tail.last.push_back(load(&first[4 * channel], 1));
    const unsigned mode = tail.modes.emplace_back(reader.next());
    if ((mode & 15u) > 2 || ((mode & 15u) < 2 && mode >> 4 != 0)) {
      return false;
    }
  }
  return true;
}

void decode_block(Reader& reader, Tail& tail, std::size_t count, std::byte* out) {
  const std::size_t channels = tail.last.size();
  std::array<unsigned, 64> controls{};
  std::generate_n(controls.begin(), channels, [&] { return reader.next(); });
  std::array<std::uint8_t, 4 * k_most_block> deltas{};
  for (std::size_t channel = 0; channel < channels; ++channel) {
    for (std::size_t byte = 0; byte < 4; ++byte) {
      const auto control = static_cast<Control>((controls[channel] >> (2 * byte)) & 3u);
      read_plane(reader, control, count, &deltas[byte * k_most_block]);
    }
    std::uint32_t& last = tail.last[channel];
    for (std::size_t i = 0; i < count; ++i) {
      last = next_channel(last, load(&deltas[i], k_most_block), tail.modes[channel]);
      std::byte* element = out + (i * channels + channel) * 4;
      for (unsigned byte = 0; byte < 4; ++byte) {
        element[byte] = static_cast<std::byte>(last >> (8 * byte));
      }
    }
  }
}

}  // namespace

bool decode_meshopt_v1(std::byte* out, std::size_t count, std::size_t stride, Bytes data) {
  const std::size_t tail_size = stride + stride / 4;
  const std::size_t padded_tail = std::max(tail_size, k_least_tail);
  if (data.size() < 1 + padded_tail) {
    return false;
  }
  Tail tail;
  tail.last.reserve(stride / 4);
  tail.modes.reserve(stride / 4);
  if (!read_tail(data.last(tail_size), stride, tail)) {
    return false;
  }
  Reader reader(data.subspan(1, data.size() - 1 - padded_tail));
  const std::size_t block = std::min((8192 / stride) & ~(k_group - 1), k_most_block);
  for (std::size_t done = 0; done < count && !reader.is_broken(); done += block) {
    decode_block(reader, tail, std::min(block, count - done), out + done * stride);
  }
  return !reader.is_broken() && reader.is_at_end();
}

}  // namespace lume::io::gltf
