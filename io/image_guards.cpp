// SPDX-License-Identifier: Apache-2.0
#include "io/image_guards.h"

#include "io/error.h"

#include <fmt/format.h>

namespace lume::io {
namespace {

constexpr std::int64_t k_max_pixels = std::int64_t{1} << 28;

// Deflate packs at most 1032 bytes into one, eight 1-bit pixels each; the other formats pack less.
constexpr std::uintmax_t k_max_pixels_per_byte = 16384;

unsigned value_at(std::span<const std::byte> bytes, std::size_t i) {
  return std::to_integer<unsigned>(bytes[i]);
}

/// Where the entropy-coded data that begins at `i` ends: at the next marker. In it 0xff stands
/// before 0x00 (a plain 0xff), before the restart markers 0xd0 ... 0xd7, and before itself as
/// padding.
std::size_t skip_entropy_coded(std::span<const std::byte> bytes, std::size_t i) {
  for (; i + 1 < bytes.size(); ++i) {
    if (value_at(bytes, i) != 0xff) continue;
    const unsigned next = value_at(bytes, i + 1);
    if (next != 0x00 && next != 0xff && (next < 0xd0 || next > 0xd7)) return i;
  }
  return bytes.size();
}

}  // namespace

void check_image_size(std::int64_t width, std::int64_t height, std::uintmax_t file_bytes,
                      const std::string& name) {
  const auto fail = [&](const char* reason) {
    throw Error(ErrorKind::input_output, name, "",
                fmt::format("the image says it is {} x {} pixels, {}", width, height, reason));
  };
  if (width <= 0 || height <= 0) fail("expected at least one");
  if (width > k_max_pixels / height) fail("expected at most 2^28 of them");
  const auto pixels = static_cast<std::uintmax_t>(width * height);
  if (pixels / k_max_pixels_per_byte > file_bytes) fail("more than its bytes can hold");
}

bool is_jpeg(std::span<const std::byte> bytes) {
  return bytes.size() >= 3 && value_at(bytes, 0) == 0xff && value_at(bytes, 1) == 0xd8 &&
         value_at(bytes, 2) == 0xff;
}

bool is_complete_jpeg(std::span<const std::byte> bytes) {
  // ITU-T T.81, annex B: markers are 0xff and a code; most are followed by the length of a segment.
  std::size_t i = 2;
  while (i + 1 < bytes.size()) {
    if (value_at(bytes, i) != 0xff) return false;
    const unsigned marker = value_at(bytes, i + 1);
    if (marker == 0xff) {  // padding before a marker
      ++i;
      continue;
    }
    if (marker == 0xd9) return true;  // EOI
    if (i + 3 >= bytes.size()) return false;
    const std::size_t length = value_at(bytes, i + 2) * 256 + value_at(bytes, i + 3);
    if (length < 2) return false;
    i += 2 + length;
    if (marker == 0xda) i = skip_entropy_coded(bytes, i);  // SOS
  }
  return false;
}

}  // namespace lume::io
