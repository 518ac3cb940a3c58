// SPDX-License-Identifier: Apache-2.0
// The codecs and filters of EXT_meshopt_compression and KHR_meshopt_compression: what was encoded
// comes back, and damage does no harm.
#include "io/gltf/meshopt.h"
#include "tests/io/meshopt_v1_encoder.h"
#include "tests/support/cases.h"
#include "tests/support/random.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lume::io {
namespace {

using gltf::Bytes;
using gltf::decode_meshopt;
using gltf::MeshoptFilter;
using gltf::MeshoptMode;
using gltf::MeshoptView;
using Stream = std::vector<std::uint8_t>;

Bytes as_bytes(const Stream& stream) {
  return {reinterpret_cast<const std::byte*>(stream.data()), stream.size()};
}

MeshoptView view_of(std::size_t count, std::size_t stride, MeshoptMode mode,
                    MeshoptFilter filter = MeshoptFilter::none) {
  MeshoptView view;
  view.count = count;
  view.stride = stride;
  view.mode = mode;
  view.filter = filter;
  return view;
}

template <class T>
std::vector<T> decode(const Stream& stream, const MeshoptView& view) {
  const std::vector<std::byte> bytes = decode_meshopt(as_bytes(stream), view);
  std::vector<T> result(bytes.size() / sizeof(T));
  std::memcpy(result.data(), bytes.data(), bytes.size());
  return result;
}

Stream encode_vertices(const void* data, std::size_t count, std::size_t stride) {
  Stream stream(meshopt_encodeVertexBufferBound(count, stride));
  stream.resize(meshopt_encodeVertexBuffer(stream.data(), stream.size(), data, count, stride));
  return stream;
}

/// Elements that wander, as vertices do, with a jump now and then.
Stream wandering(test::Random& random, std::size_t count, std::size_t stride) {
  Stream data(count * stride);
  for (std::size_t i = 0; i < data.size(); ++i) {
    const std::uint32_t step = random.below(20) == 0 ? random.below(256) : random.below(3);
    data[i] = static_cast<std::uint8_t>((i < stride ? 0u : data[i - stride]) + step);
  }
  return data;
}

TEST(GltfMeshopt, Attributes_ComeBackExactly) {
  test::Random random(1);
  for (int i = 0; i < test::cases(300); ++i) {
    const std::size_t stride = 4 * (1 + random.below(64));
    const std::size_t count = 1 + random.below(700);
    const Stream data = wandering(random, count, stride);
    const auto stream = encode_vertices(data.data(), count, stride);
    EXPECT_EQ(decode<std::uint8_t>(stream, view_of(count, stride, MeshoptMode::attributes)), data);
  }
}

TEST(GltfMeshopt, AttributesOfVersionOne_ComeBackExactly) {
  test::Random random(2);
  for (int i = 0; i < test::cases(300); ++i) {
    const std::size_t stride = 4 * (1 + random.below(64));
    const std::size_t count = 1 + random.below(700);
    const Stream data = wandering(random, count, stride);
    const Stream stream = test::encode_meshopt_v1(data, stride, random);
    EXPECT_EQ(decode<std::uint8_t>(stream, view_of(count, stride, MeshoptMode::attributes)), data)
        << "stride " << stride << " count " << count;
  }
}

/// The extension's own example of 16 deltas in four bits, two of them beyond.
TEST(GltfMeshopt, ExampleOfTheExtension_DecodesAsItSays) {
  Stream stream = {0xA1, 0b10101001, 0x02, 0x17, 0x5F, 0xF0, 0xBC,
                   0x77, 0xA9,       0x21, 0x00, 0x34, 0xB5};
  stream.resize(stream.size() + 24);
  const auto data = decode<std::uint8_t>(stream, view_of(16, 4, MeshoptMode::attributes));
  const int deltas[] = {-1, -4, -3, 26, -91, 0, -6, 6, -4, -4, 5, -5, 1, -1, 0, 0};
  int value = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    value += deltas[i];
    EXPECT_EQ(data[4 * i], static_cast<std::uint8_t>(value)) << i;
    EXPECT_EQ(data[4 * i + 1], 0);
  }
}

/// The codec may turn a triangle, (a, b, c) to (b, c, a).
TEST(GltfMeshopt, Triangles_ComeBackTurned) {
  test::Random random(3);
  for (const std::size_t size : {2u, 4u}) {
    std::vector<unsigned int> indices;
    for (int i = 0; i < 999; ++i) indices.push_back(random.below(400));
    Stream stream(meshopt_encodeIndexBufferBound(indices.size(), 400));
    stream.resize(
        meshopt_encodeIndexBuffer(stream.data(), stream.size(), indices.data(), indices.size()));
    const MeshoptView view = view_of(indices.size(), size, MeshoptMode::triangles);
    const std::vector<std::byte> bytes = decode_meshopt(as_bytes(stream), view);
    for (std::size_t t = 0; t < indices.size(); t += 3) {
      std::vector<unsigned int> triangle(3);
      for (std::size_t c = 0; c < 3; ++c) {
        std::memcpy(&triangle[c], bytes.data() + (t + c) * size, size);
      }
      const auto first = std::find(triangle.begin(), triangle.end(), indices[t]);
      ASSERT_NE(first, triangle.end());
      std::rotate(triangle.begin(), first, triangle.end());
      EXPECT_TRUE(std::is_permutation(triangle.begin(), triangle.end(), &indices[t]));
    }
  }
}

TEST(GltfMeshopt, Indices_ComeBackExactly) {
  test::Random random(4);
  std::vector<unsigned int> indices;
  for (int i = 0; i < 1001; ++i) indices.push_back(random.below(60000));
  Stream stream(meshopt_encodeIndexSequenceBound(indices.size(), 60000));
  stream.resize(
      meshopt_encodeIndexSequence(stream.data(), stream.size(), indices.data(), indices.size()));
  const auto wide = decode<std::uint32_t>(stream, view_of(1001, 4, MeshoptMode::indices));
  const auto narrow = decode<std::uint16_t>(stream, view_of(1001, 2, MeshoptMode::indices));
  EXPECT_TRUE(std::equal(indices.begin(), indices.end(), wide.begin(), wide.end()));
  EXPECT_TRUE(std::equal(indices.begin(), indices.end(), narrow.begin(), narrow.end()));
}

/// Four components of random unit vectors or quaternions, encoded in `bits`.
template <class Encode>
std::vector<std::int16_t> filtered(std::vector<geometry::Vec4>& values, MeshoptFilter filter,
                                   const Encode& encode) {
  test::Random random(5);
  for (geometry::Vec4& v : values) {
    v = geometry::Vec4(random.direction(),
                       filter == MeshoptFilter::quaternion ? random.uniform(-1.0f, 1.0f) : 0.0f);
    v /= glm::length(v);
  }
  std::vector<std::int16_t> data(4 * values.size());
  encode(data.data(), values.size(), 8, 12, &values[0].x);
  const Stream stream = encode_vertices(data.data(), values.size(), 8);
  return decode<std::int16_t>(stream, view_of(values.size(), 8, MeshoptMode::attributes, filter));
}

TEST(GltfMeshopt, Octahedral_GivesDirectionsBack) {
  std::vector<geometry::Vec4> normals(500);
  const auto data = filtered(normals, MeshoptFilter::octahedral, meshopt_encodeFilterOct);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(data[4 * i + static_cast<std::size_t>(c)] / 32767.0f, normals[i][c], 2.5f / 2047);
    }
  }
}

TEST(GltfMeshopt, Quaternion_GivesRotationsBack) {
  std::vector<geometry::Vec4> rotations(500);
  const auto data = filtered(rotations, MeshoptFilter::quaternion, meshopt_encodeFilterQuat);
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    float cosine = 0.0f;  // q and -q are one rotation
    for (int c = 0; c < 4; ++c) {
      cosine += data[4 * i + static_cast<std::size_t>(c)] / 32767.0f * rotations[i][c];
    }
    EXPECT_NEAR(std::abs(cosine), 1.0f, 1e-4f);
  }
}

TEST(GltfMeshopt, Exponential_GivesFloatsBack) {
  test::Random random(6);
  std::vector<float> values;
  for (int i = 0; i < 600; ++i) {
    values.push_back(random.uniform(-1.0f, 1.0f) *
                     std::exp2(static_cast<float>(random.below(40)) - 20.0f));
  }
  std::vector<std::uint32_t> data(values.size());
  meshopt_encodeFilterExp(data.data(), values.size(), 4, 20, values.data());
  const auto decoded =
      decode<float>(encode_vertices(data.data(), values.size(), 4),
                    view_of(values.size(), 4, MeshoptMode::attributes, MeshoptFilter::exponential));
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(decoded[i], values[i], std::abs(values[i]) * 0x1p-18f);
  }
}

/// K bits: Y, Co, Cg chosen so that R, G, B are in range; scaled to the component's whole range.
template <class T>
void expect_colors(int bits) {
  using Signed = std::make_signed_t<T>;
  constexpr auto k_largest = static_cast<double>(std::numeric_limits<T>::max());
  const int limit = 1 << bits;
  test::Random random(static_cast<unsigned>(bits));
  std::vector<T> data;
  std::vector<double> expected;
  while (expected.size() < 400) {
    const auto any = [&] {
      return static_cast<int>(random.below(static_cast<std::uint32_t>(limit)));
    };
    const int y = any();
    const int co = any() - limit / 2;
    const int cg = any() - limit / 2;
    const int rgb[] = {y + co - cg, y + cg, y - co - cg};
    if (std::any_of(rgb, rgb + 3, [&](int v) { return v < 0 || v >= limit; })) continue;
    const int alpha = any() / 2;
    data.push_back(static_cast<T>(y));
    data.push_back(static_cast<T>(static_cast<Signed>(co)));
    data.push_back(static_cast<T>(static_cast<Signed>(cg)));
    data.push_back(static_cast<T>(alpha | limit / 2));
    for (const int v : rgb) expected.push_back(v * k_largest / (limit - 1));
    expected.push_back((2 * alpha + alpha % 2) * k_largest / (limit - 1));
  }
  const std::size_t count = expected.size() / 4;
  const auto decoded =
      decode<T>(encode_vertices(data.data(), count, 4 * sizeof(T)),
                view_of(count, 4 * sizeof(T), MeshoptMode::attributes, MeshoptFilter::color));
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(decoded[i], expected[i], k_largest > 255 ? 0.51 : 0.5001) << i;
  }
}

TEST(GltfMeshopt, Color_GivesRgbaBack) {
  for (const int bits : {4, 6, 8}) expect_colors<std::uint8_t>(bits);
  for (const int bits : {8, 11, 16}) expect_colors<std::uint16_t>(bits);
}

TEST(GltfMeshopt, CountsThatCannotBe_AllocateNothing) {
  Stream stream(64);
  for (const auto& [first, mode] : {std::pair{0xA0, MeshoptMode::attributes},
                                    {0xA1, MeshoptMode::attributes},
                                    {0xE1, MeshoptMode::triangles},
                                    {0xD1, MeshoptMode::indices}}) {
    stream[0] = static_cast<std::uint8_t>(first);
    const MeshoptView view = view_of(std::size_t{3} << 28, 4, mode);
    EXPECT_THROW(static_cast<void>(decode_meshopt(as_bytes(stream), view)), std::runtime_error);
  }
}

TEST(GltfMeshopt, LaterVersion_IsNamed) {
  const Stream stream(100, 0xA2);
  try {
    static_cast<void>(decode_meshopt(as_bytes(stream), view_of(1, 4, MeshoptMode::attributes)));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("version 2"));
  }
}

TEST(GltfMeshopt, DamagedStreams_DecodeOrThrow) {
  test::Random random(7);
  const Stream data = wandering(random, 300, 12);
  std::vector<unsigned int> indices;
  for (unsigned i = 0; i < 600; ++i) indices.push_back(i / 3 + i % 3);
  std::vector<std::pair<Stream, MeshoptView>> good = {
      {encode_vertices(data.data(), 300, 12), view_of(300, 12, MeshoptMode::attributes)},
      {test::encode_meshopt_v1(data, 12, random), view_of(300, 12, MeshoptMode::attributes)}};
  Stream triangles(meshopt_encodeIndexBufferBound(600, 300));
  triangles.resize(
      meshopt_encodeIndexBuffer(triangles.data(), triangles.size(), indices.data(), 600));
  good.emplace_back(triangles, view_of(600, 4, MeshoptMode::triangles));
  int refused = 0;
  for (int i = 0; i < test::cases(6000); ++i) {
    auto [stream, view] = good[random.below(3)];
    for (std::uint32_t flips = 1 + random.below(4); flips > 0; --flips) {
      stream[random.below(static_cast<std::uint32_t>(stream.size()))] ^=
          static_cast<std::uint8_t>(1u << random.below(8));
    }
    if (random.below(8) == 0)
      stream.resize(random.below(static_cast<std::uint32_t>(stream.size())));
    try {
      EXPECT_EQ(decode_meshopt(as_bytes(stream), view).size(), view.count * view.stride);
    } catch (const std::runtime_error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, test::cases(600));
}

}  // namespace
}  // namespace lume::io
