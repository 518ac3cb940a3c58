// SPDX-License-Identifier: Apache-2.0
// Accessors against a slow decoder that follows the specification's tables byte by byte.
#include "io/error.h"
#include "io/gltf/accessors.h"
#include "tests/support/gltf_file.h"
#include "tests/support/paths.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::io::gltf {
namespace {

using test::GltfFile;
using test::Random;

constexpr int k_component_types[] = {5120, 5121, 5122, 5123, 5125, 5126};
constexpr std::size_t k_component_bytes[] = {1, 1, 2, 2, 4, 4};

struct RandomAccessor {
  GltfFile file;
  std::size_t kind = 0;  ///< index into the tables above
  std::size_t components = 0;
  std::size_t count = 0;
  std::size_t stride = 0;
  std::size_t start = 0;  ///< in the buffer
  bool has_view = true;
  bool normalized = false;
  std::vector<std::uint32_t> sparse_indices;
  std::size_t sparse_start = 0;
};

std::vector<std::uint8_t> random_bytes(Random& random, std::size_t size, bool floats) {
  std::vector<std::uint8_t> bytes(size);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
  for (std::size_t i = 3; floats && i < size; i += 4) {
    bytes[i] &= 0x3F;  // small positive floats, none of them infinite
  }
  return bytes;
}

std::uint32_t below(Random& random, std::size_t count) {
  return random.below(static_cast<std::uint32_t>(count));
}

/// Adds the sparse part: strictly growing indices of a random width.
void add_sparse(RandomAccessor& accessor, Random& random, nlohmann::json& json) {
  for (std::uint32_t i = 0; i < accessor.count; ++i) {
    if (random.below(3) == 0) accessor.sparse_indices.push_back(i);
  }
  if (accessor.sparse_indices.empty()) accessor.sparse_indices.push_back(0);
  const std::size_t element = accessor.components * k_component_bytes[accessor.kind];
  const std::size_t count = accessor.sparse_indices.size();
  const std::size_t view =
      accessor.file.add_view(random_bytes(random, count * element, accessor.kind == 5));
  accessor.sparse_start = accessor.file.json["bufferViews"][view]["byteOffset"];
  const bool wide = random.below(2) == 0;
  std::vector<std::uint8_t> narrow(accessor.sparse_indices.begin(), accessor.sparse_indices.end());
  const std::size_t indices =
      wide ? accessor.file.add_view(accessor.sparse_indices) : accessor.file.add_view(narrow);
  json["sparse"] = {{"count", count},
                    {"indices", {{"bufferView", indices}, {"componentType", wide ? 5125 : 5121}}},
                    {"values", {{"bufferView", view}}}};
}

RandomAccessor make_accessor(Random& random) {
  RandomAccessor accessor;
  accessor.kind = below(random, std::size(k_component_types));
  accessor.components = 2 + below(random, 3);
  accessor.count = 1 + below(random, 40);
  accessor.normalized = accessor.kind < 4 && random.below(2) == 0;
  accessor.has_view = random.below(8) != 0;
  const std::size_t element = accessor.components * k_component_bytes[accessor.kind];
  nlohmann::json json = {{"componentType", k_component_types[accessor.kind]},
                         {"count", accessor.count},
                         {"type", "VEC" + std::to_string(accessor.components)},
                         {"normalized", accessor.normalized}};
  if (accessor.has_view) {
    const bool interleaved = random.below(2) == 0;
    accessor.stride =
        interleaved ? (element + 3) / 4 * 4 + std::size_t{4} * below(random, 4) : element;
    const std::size_t offset = std::size_t{4} * below(random, 3);
    const std::size_t size = offset + (accessor.count - 1) * accessor.stride + element;
    accessor.file.append(random_bytes(random, std::size_t{4} * below(random, 4), false));
    const std::size_t view = accessor.file.add_view(random_bytes(random, size, accessor.kind == 5));
    accessor.start =
        accessor.file.json["bufferViews"][view]["byteOffset"].get<std::size_t>() + offset;
    if (interleaved) accessor.file.json["bufferViews"][view]["byteStride"] = accessor.stride;
    json["bufferView"] = view;
    json["byteOffset"] = offset;
  }
  if (random.below(3) == 0) add_sparse(accessor, random, json);
  accessor.file.add("accessors", json);
  accessor.file.append(std::vector<std::uint8_t>{0});  // there is always a buffer
  return accessor;
}

/// One component at a byte of the buffer, put together from its bytes.
double decode(const RandomAccessor& accessor, std::size_t offset) {
  const std::size_t size = k_component_bytes[accessor.kind];
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    bits |= std::uint32_t{accessor.file.bytes[offset + i]} << (8 * i);
  }
  if (accessor.kind == 5) {
    // IEEE 754 single precision by its fields.
    const int exponent = static_cast<int>((bits >> 23) & 0xFF);
    const double fraction = static_cast<double>(bits & 0x7FFFFF) / 8388608.0;
    const double value =
        exponent == 0 ? std::ldexp(fraction, -126) : std::ldexp(1.0 + fraction, exponent - 127);
    return (bits >> 31) != 0 ? -value : value;
  }
  const bool is_signed = accessor.kind == 0 || accessor.kind == 2;
  const double range = std::ldexp(1.0, static_cast<int>(8 * size));
  double value = bits;
  if (is_signed && value >= range / 2) value -= range;
  if (!accessor.normalized) return value;
  return std::max(value / (is_signed ? range / 2 - 1 : range - 1), -1.0);
}

double expected(const RandomAccessor& accessor, std::size_t element, std::size_t component) {
  const std::size_t size = k_component_bytes[accessor.kind];
  for (std::size_t i = 0; i < accessor.sparse_indices.size(); ++i) {
    if (accessor.sparse_indices[i] == element) {
      return decode(accessor, accessor.sparse_start + (i * accessor.components + component) * size);
    }
  }
  return accessor.has_view
             ? decode(accessor, accessor.start + element * accessor.stride + component * size)
             : 0.0;
}

template <class V>
void expect_values(const RandomAccessor& accessor, const std::vector<V>& values) {
  ASSERT_EQ(values.size(), accessor.count);
  for (std::size_t i = 0; i < accessor.count; ++i) {
    for (std::size_t c = 0; c < accessor.components; ++c) {
      const auto wanted = static_cast<float>(expected(accessor, i, c));
      const float value = values[i][static_cast<int>(c)];
      ASSERT_FLOAT_EQ(value, wanted) << "element " << i << " component " << c << " of type "
                                     << k_component_types[accessor.kind];
    }
  }
}

TEST(GltfAccessor, RandomLayouts_MatchSlowDecoder) {
  const tests::TemporaryFolder folder;
  Random random(42);
  for (int i = 0; i < 1000; ++i) {
    const RandomAccessor accessor = make_accessor(random);
    const Document document = open_document(accessor.file.write(folder / "a.gltf"));
    if (accessor.components == 2) expect_values(accessor, read_vec2(document, 0));
    if (accessor.components == 3) expect_values(accessor, read_vec3(document, 0));
    if (accessor.components == 4) expect_values(accessor, read_vec4(document, 0));
    if (HasFatalFailure()) return;
  }
}

TEST(GltfAccessor, IndicesOfEveryWidth_Agree) {
  const tests::TemporaryFolder folder;
  GltfFile file;
  file.add_accessor<std::uint8_t>({0, 7, 255}, 5121, "SCALAR", 1);
  file.add_accessor<std::uint16_t>({0, 7, 255}, 5123, "SCALAR", 1);
  file.add_accessor<std::uint32_t>({0, 7, 255}, 5125, "SCALAR", 1);
  const Document document = open_document(file.write(folder / "a.gltf"));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read_indices(document, i), (std::vector<std::uint32_t>{0, 7, 255}));
  }
}

TEST(GltfAccessor, NormalizedLimits_AreExact) {
  const tests::TemporaryFolder folder;
  GltfFile file;
  file.add_accessor<std::int8_t>({-128, -127, 0, 127}, 5120, "VEC4", 4);
  file.add_accessor<std::uint16_t>({0, 65535, 0, 65535}, 5123, "VEC4", 4);
  for (nlohmann::json& accessor : file.json["accessors"]) accessor["normalized"] = true;
  const Document document = open_document(file.write(folder / "a.gltf"));
  EXPECT_EQ(read_vec4(document, 0)[0], geometry::Vec4(-1, -1, 0, 1));
  EXPECT_EQ(read_vec4(document, 1)[0], geometry::Vec4(0, 1, 0, 1));
}

}  // namespace
}  // namespace lume::io::gltf
