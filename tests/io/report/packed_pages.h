// SPDX-License-Identifier: Apache-2.0
// What a page holds, read back by other means than its own scripts.
#pragma once

#include "io/gltf/resources.h"

#include <gtest/gtest.h>
#include <zlib.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lume::test {

/// The text of the script element of that id; fails if there is not exactly one.
inline std::string script_text(const std::string& page, const std::string& id) {
  const std::size_t start = page.find(" id=\"" + id + "\">");
  EXPECT_NE(start, std::string::npos) << id;
  EXPECT_EQ(page.find(" id=\"" + id + "\">", start + 1), std::string::npos) << id;
  const std::size_t first = page.find('>', start) + 1;
  return page.substr(first, page.find("</script>", first) - first);
}

inline nlohmann::json report_of(const std::string& page) {
  return nlohmann::json::parse(script_text(page, "report"));
}

inline std::vector<unsigned char> inflate_base64(const std::string& text, std::size_t size) {
  const std::vector<std::byte> packed = io::gltf::base64_decode(text);
  std::vector<unsigned char> bytes(size + 1);
  uLongf length = bytes.size();
  EXPECT_EQ(uncompress(bytes.data(), &length, reinterpret_cast<const Bytef*>(packed.data()),
                       packed.size()),
            Z_OK);
  EXPECT_EQ(length, size);
  bytes.resize(size);
  return bytes;
}

/// Codes of red, green and blue, or of the only plane.
inline std::vector<std::vector<std::uint32_t>> unpack(const std::string& data, int width,
                                                      int height, int planes, int bytes) {
  const auto w = static_cast<std::size_t>(width);
  const std::size_t pixels = w * static_cast<std::size_t>(height);
  const auto per_code = static_cast<std::size_t>(bytes);
  const auto stored = inflate_base64(data, pixels * static_cast<std::size_t>(planes) * per_code);
  std::vector<std::vector<std::uint32_t>> codes(static_cast<std::size_t>(planes));
  const std::uint32_t mask = bytes == 4 ? 0xFFFFFFFFu : (1u << (8 * bytes)) - 1u;
  for (std::size_t p = 0; p < codes.size(); ++p) {
    codes[p].resize(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
      std::uint32_t distance = 0;
      for (std::size_t k = 0; k < per_code; ++k) {
        distance = distance * 256u + stored[(p * per_code + k) * pixels + i];
      }
      std::uint32_t neighbour = 0;
      if (i % w != 0) {
        neighbour = codes[p][i - 1];
      } else if (i != 0) {
        neighbour = codes[p][i - w];
      }
      codes[p][i] = (distance + neighbour) & mask;
    }
  }
  for (std::size_t i = 0; planes == 3 && i < pixels; ++i) {
    codes[0][i] = (codes[0][i] + codes[1][i]) & mask;
    codes[2][i] = (codes[2][i] + codes[1][i]) & mask;
  }
  return codes;
}

/// IEEE 754-2008, binary16.
inline float half_value(std::uint32_t bits) {
  const float sign = (bits & 0x8000u) != 0 ? -1.0f : 1.0f;
  const int exponent = static_cast<int>((bits >> 10) & 31u);
  const auto mantissa = static_cast<float>(bits & 1023u);
  if (exponent == 31) return mantissa != 0.0f ? std::nanf("") : sign * INFINITY;
  if (exponent == 0) return sign * std::ldexp(mantissa, -24);
  return sign * std::ldexp(1024.0f + mantissa, exponent - 25);
}

}  // namespace lume::test
