// SPDX-License-Identifier: Apache-2.0
// The sizes of accessor elements (glTF 2.0, section 3.6.2.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>

namespace lume::io::gltf {

/// The numbers glTF gives to component types.
enum class Component : std::uint32_t {
  i8 = 5120,
  u8 = 5121,
  i16 = 5122,
  u16 = 5123,
  u32 = 5125,
  f32 = 5126,
};

/// Bytes of a component; 0 for a number that stands for none.
[[nodiscard]] constexpr std::size_t component_size(std::uint64_t type) {
  constexpr std::size_t k_sizes[] = {1, 1, 2, 2, 0, 4, 4};
  constexpr auto k_first = static_cast<std::uint64_t>(Component::i8);
  return type >= k_first && type - k_first < std::size(k_sizes) ? k_sizes[type - k_first] : 0;
}

/// An accessor's "type".
struct ElementType {
  std::size_t columns = 0;  ///< 0: no such type
  std::size_t rows = 0;

  /// Bytes of an element; matrix columns begin on multiples of four bytes.
  [[nodiscard]] constexpr std::size_t size(std::size_t component_bytes) const {
    const std::size_t column = rows * component_bytes;
    return columns == 1 ? column : columns * ((column + 3) / 4 * 4);
  }
};

[[nodiscard]] constexpr ElementType element_type(std::string_view name) {
  if (name == "SCALAR") {
    return {1, 1};
  }
  if (name.size() != 4 || name[3] < '2' || name[3] > '4') {
    return {};
  }
  const auto n = static_cast<std::size_t>(name[3] - '0');
  if (name.starts_with("VEC")) {
    return {1, n};
  }
  return name.starts_with("MAT") ? ElementType{n, n} : ElementType{};
}

}  // namespace lume::io::gltf
