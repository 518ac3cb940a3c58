// SPDX-License-Identifier: Apache-2.0
#include "io/base64.h"

#include <cstdint>

namespace lume::io {

std::string base64_encode(std::string_view bytes) {
  constexpr std::string_view k_digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  for (std::size_t i = 0, to = 0; i < bytes.size(); i += 3, to += 4) {
    const std::string_view group = bytes.substr(i, 3);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = (bits << 8) | (k < group.size() ? static_cast<unsigned char>(group[k]) : 0u);
    }
    for (std::size_t k = 0; k <= group.size(); ++k) {
      text[to + k] = k_digits[(bits >> (18 - 6 * k)) & 63u];
    }
  }
  return text;
}

}  // namespace lume::io
