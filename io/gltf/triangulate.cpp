// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/triangulate.h"

namespace lume::io::gltf {
namespace {

using geometry::UVec3;

/// `vertex` gives the vertex of a place in the sequence. The orders are those of glTF 2.0, section
/// 3.7.2.1.
template <class Vertex>
std::vector<UVec3> triangulate_sequence(std::size_t count, Mode mode, const Vertex& vertex) {
  std::vector<UVec3> triangles;
  if (count < 3) {
    return triangles;
  }
  if (mode == Mode::triangles) {
    triangles.reserve(count / 3);
    for (std::size_t i = 0; i + 2 < count; i += 3) {
      triangles.push_back({vertex(i), vertex(i + 1), vertex(i + 2)});
    }
    return triangles;
  }
  triangles.reserve(count - 2);
  for (std::size_t i = 0; i + 2 < count; ++i) {
    if (mode == Mode::triangle_fan) {
      triangles.push_back({vertex(i + 1), vertex(i + 2), vertex(0)});
    } else {
      // Every other triangle of a strip is wound the other way round.
      triangles.push_back({vertex(i), vertex(i + 1 + i % 2), vertex(i + 2 - i % 2)});
    }
  }
  return triangles;
}

}  // namespace

std::vector<UVec3> triangulate(std::span<const std::uint32_t> indices, Mode mode) {
  return triangulate_sequence(indices.size(), mode, [&](std::size_t i) { return indices[i]; });
}

std::vector<UVec3> triangulate(std::uint32_t count, Mode mode) {
  return triangulate_sequence(count, mode,
                              [](std::size_t i) { return static_cast<std::uint32_t>(i); });
}

}  // namespace lume::io::gltf
