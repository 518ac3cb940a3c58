// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/tangent_groups.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>
#include <unordered_map>

namespace lume::io::gltf {
namespace {

using geometry::DVec3;
using geometry::Mesh;
using geometry::Vec2;
using geometry::Vec3;

using Key = std::array<float, 8>;

struct KeyHash {
  std::size_t operator()(const Key& key) const {
    std::uint64_t hash = 0;
    for (const float value : key) {
      // Fibonacci hashing (Knuth, The Art of Computer Programming 3, section 6.4), word by word.
      hash = (std::rotl(hash, 29) ^ std::bit_cast<std::uint32_t>(value)) * 0x9E3779B97F4A7C15u;
    }
    return hash ^ (hash >> 32);
  }
};

/// For each vertex the first that is equal in position, normal and texture coordinates.
std::vector<std::uint32_t> weld(const Mesh& mesh, const std::vector<Vec2>& uvs) {
  std::unordered_map<Key, std::uint32_t, KeyHash> first;
  first.reserve(mesh.positions.size());
  std::vector<std::uint32_t> result(mesh.positions.size());
  for (std::uint32_t i = 0; i < result.size(); ++i) {
    const Vec3& p = mesh.positions[i];
    const Vec3& n = mesh.normals[i];
    Key key = {p.x, p.y, p.z, n.x, n.y, n.z, uvs[i].x, uvs[i].y};
    for (float& value : key) {
      value += 0.0f;  // -0 and 0 are equal and must hash alike
    }
    result[i] = first.try_emplace(key, i).first->second;
  }
  return result;
}

/// The gradient of u over the triangle. With edges d1, d2 and their differences (s1, t1), (s2, t2)
/// of u and of v upward, dP/du is (t2 d1 - t1 d2) / (s1 t2 - s2 t1); the divisor's size does not
/// turn it.
void add_gradient(const Mesh& mesh, const std::vector<Vec2>& uvs, TangentFace& face) {
  const geometry::UVec3& v = face.vertices;
  const Vec3& a = mesh.positions[v.x];
  const Vec3& b = mesh.positions[v.y];
  const Vec3& c = mesh.positions[v.z];
  face.is_degenerate = a == b || b == c || c == a;
  const Vec2 uv1 = uvs[v.y] - uvs[v.x];
  const Vec2 uv2 = uvs[v.z] - uvs[v.x];
  const float area = uv1.y * uv2.x - uv1.x * uv2.y;
  face.keeps_orientation = area > 0.0f;
  const DVec3 d1 = DVec3(b) - DVec3(a);
  const DVec3 d2 = DVec3(c) - DVec3(a);
  const DVec3 along_u = double{uv1.y} * d2 - double{uv2.y} * d1;
  const DVec3 along_v = double{uv1.x} * d2 - double{uv2.x} * d1;
  face.along_u = face.keeps_orientation ? along_u : -along_u;
  constexpr float k_least = std::numeric_limits<float>::min();
  face.fits_any = !(std::abs(area) > k_least) || !(length(along_u) > double{k_least}) ||
                  !(length(along_v) > double{k_least});
}

struct Edge {
  std::uint32_t low = 0;  ///< vertices
  std::uint32_t high = 0;
  std::uint32_t face = 0;
  std::uint32_t corner = 0;  ///< from this one to the next
  bool goes_up = false;      ///< from low to high
};

std::vector<Edge> list_edges(const TangentFaces& faces) {
  std::vector<Edge> edges;
  edges.reserve(3 * faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    if (faces[f].is_degenerate) {
      continue;
    }
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t from = faces[f].vertices[static_cast<int>(c)];
      const std::uint32_t to = faces[f].vertices[static_cast<int>((c + 1) % 3)];
      edges.push_back({std::min(from, to), std::max(from, to), f, c, from < to});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high, a.face, a.corner) < std::tie(b.low, b.high, b.face, b.corner);
  });
  return edges;
}

/// Two faces are neighbours across an edge that they run along in opposite directions. Where more
/// than two meet, the first that goes up is joined to the first that goes down, and so on.
void join_at_edge(const Edge* begin, const Edge* end, TangentFaces& faces) {
  const auto find = [&](const Edge* from, bool goes_up) {
    return std::find_if(from, end, [=](const Edge& edge) { return edge.goes_up == goes_up; });
  };
  const Edge* up = find(begin, true);
  const Edge* down = find(begin, false);
  while (up != end && down != end) {
    faces[up->face].neighbours[up->corner] = down->face;
    faces[down->face].neighbours[down->corner] = up->face;
    up = find(up + 1, true);
    down = find(down + 1, false);
  }
}

void find_neighbours(TangentFaces& faces) {
  const std::vector<Edge> edges = list_edges(faces);
  const Edge* const end = edges.data() + edges.size();
  for (const Edge* begin = edges.data(); begin != end;) {
    const Edge* const next = std::find_if(begin, end, [=](const Edge& edge) {
      return edge.low != begin->low || edge.high != begin->high;
    });
    join_at_edge(begin, next, faces);
    begin = next;
  }
}

int corner_at(const TangentFace& face, std::uint32_t vertex) {
  return face.vertices.x == vertex ? 0 : face.vertices.y == vertex ? 1 : 2;
}

/// Whether the corner may join. A face without a gradient takes the orientation of the first group
/// that meets it.
bool may_join(TangentFace& face, std::size_t corner, const TangentGroup& group) {
  if (face.groups[corner] != TangentFace::k_none) {
    return false;
  }
  const bool is_free = face.groups == TangentFace().groups;
  if (face.fits_any && is_free) {
    face.keeps_orientation = group.keeps_orientation;
  }
  return face.keeps_orientation == group.keeps_orientation;
}

/// Fills a group from one face over the edges at its vertex.
void grow(TangentFaces& faces, std::uint32_t first, std::uint32_t number, TangentGroup& group) {
  std::vector<std::uint32_t> open = {first};
  while (!open.empty()) {
    const std::uint32_t f = open.back();
    open.pop_back();
    TangentFace& face = faces[f];
    const int corner = corner_at(face, group.vertex);
    const auto c = static_cast<std::size_t>(corner);
    if (!may_join(face, c, group)) {
      continue;
    }
    face.groups[c] = number;
    group.corners.emplace_back(f, corner);
    for (const std::uint32_t neighbour : {face.neighbours[(c + 2) % 3], face.neighbours[c]}) {
      if (neighbour != TangentFace::k_none) {
        open.push_back(neighbour);
      }
    }
  }
}

/// Corners that no group reached, those of degenerate faces above all, join the first at their
/// vertex.
void adopt_strays(TangentFaces& faces) {
  std::unordered_map<std::uint32_t, std::uint32_t> first;
  const auto for_each_corner = [&](const auto& visit) {
    for (TangentFace& face : faces) {
      for (int c = 0; c < 3; ++c) {
        visit(face.vertices[c], face.groups[static_cast<std::size_t>(c)]);
      }
    }
  };
  for_each_corner([&](std::uint32_t vertex, std::uint32_t group) {
    if (group != TangentFace::k_none) {
      first.try_emplace(vertex, group);
    }
  });
  for_each_corner([&](std::uint32_t vertex, std::uint32_t& group) {
    if (group == TangentFace::k_none) {
      const auto it = first.find(vertex);
      group = it == first.end() ? TangentFace::k_none : it->second;
    }
  });
}

}  // namespace

TangentFaces make_tangent_faces(const Mesh& mesh, std::size_t set) {
  const std::vector<Vec2>& uvs = mesh.texcoords[set];
  const std::vector<std::uint32_t> welded = weld(mesh, uvs);
  TangentFaces faces(mesh.triangles.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (int c = 0; c < 3; ++c) {
      faces[f].vertices[c] = welded[mesh.triangles[f][c]];
    }
    add_gradient(mesh, uvs, faces[f]);
  }
  find_neighbours(faces);
  return faces;
}

std::vector<TangentGroup> group_corners(TangentFaces& faces) {
  std::vector<TangentGroup> groups;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (int c = 0; c < 3 && !faces[f].is_degenerate && !faces[f].fits_any; ++c) {
      if (faces[f].groups[static_cast<std::size_t>(c)] == TangentFace::k_none) {
        const auto number = static_cast<std::uint32_t>(groups.size());
        TangentGroup& group = groups.emplace_back();
        group.vertex = faces[f].vertices[c];
        group.keeps_orientation = faces[f].keeps_orientation;
        grow(faces, f, number, group);
      }
    }
  }
  adopt_strays(faces);
  return groups;
}

}  // namespace lume::io::gltf
