// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/closed_mesh.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace lume::renderer {
namespace {

using geometry::DVec3;
using geometry::UVec3;
using geometry::Vec3;

/// For each position the lowest index that has the same one.
std::vector<std::uint32_t> weld(const std::vector<Vec3>& positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    return std::array{positions[i].x, positions[i].y, positions[i].z};
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return key(a) != key(b) ? key(a) < key(b) : a < b;
  });
  std::vector<std::uint32_t> welded(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool again = i > 0 && key(order[i]) == key(order[i - 1]);
    welded[order[i]] = again ? welded[order[i - 1]] : order[i];
  }
  return welded;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// The edges of all triangles, each in the direction in which its triangle runs along it.
std::vector<Edge> directed_edges(const geometry::Mesh& mesh) {
  const std::vector<std::uint32_t> welded = weld(mesh.positions);
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const UVec3& triangle : mesh.triangles) {
    const std::array corners = {welded[triangle.x], welded[triangle.y], welded[triangle.z]};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(corners[i], corners[(i + 1) % 3]);
  }
  return edges;
}

/// Six times the volume that the triangles enclose, above 0 if their fronts are outside: each adds
/// the volume between it and one point (Gauss's theorem).
double signed_volume(const geometry::Mesh& mesh) {
  double volume = 0.0;
  const DVec3 apex(mesh.positions.front());
  for (const UVec3& triangle : mesh.triangles) {
    const DVec3 a = DVec3(mesh.positions[triangle.x]) - apex;
    const DVec3 b = DVec3(mesh.positions[triangle.y]) - apex;
    const DVec3 c = DVec3(mesh.positions[triangle.z]) - apex;
    volume += dot(a, cross(b, c));
  }
  return volume;
}

}  // namespace

ClosedMesh examine_closed(const geometry::Mesh& mesh) {
  std::vector<Edge> edges = directed_edges(mesh);
  if (edges.empty()) return {};
  std::vector<Edge> opposite(edges);
  for (Edge& edge : opposite) std::swap(edge.first, edge.second);
  std::sort(edges.begin(), edges.end());
  std::sort(opposite.begin(), opposite.end());
  const bool each_once = std::adjacent_find(edges.begin(), edges.end()) == edges.end();
  return {each_once && edges == opposite, signed_volume(mesh) > 0.0};
}

}  // namespace lume::renderer
