// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/tangents.h"

#include "io/gltf/tangent_groups.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <utility>

namespace lume::io::gltf {
namespace {

using geometry::DVec3;
using geometry::Mesh;
using geometry::Vec3;
using geometry::Vec4;

DVec3 normalize_or_zero(const DVec3& v) {
  const double size = length(v);
  return size > 0.0 && std::isfinite(size) ? v / size : DVec3(0.0);
}

/// What is left of `v` in the plane across `normal`, of length 1.
DVec3 flattened(const DVec3& v, const DVec3& normal) {
  return normalize_or_zero(v - normal * dot(normal, v));
}

/// The mean of the triangles' tangents around a vertex, each weighted by its angle there, measured
/// in the plane across the vertex's normal (Mikkelsen, 2008, Simulation of Wrinkled Surfaces
/// Revisited, section 4.6).
Vec4 group_tangent(const Mesh& mesh, const TangentFaces& faces, const TangentGroup& group) {
  const DVec3 normal(mesh.normals[group.vertex]);
  DVec3 sum(0.0);
  for (const auto& [number, corner] : group.corners) {
    const TangentFace& face = faces[number];
    if (face.fits_any) {
      continue;
    }
    const DVec3 here(mesh.positions[face.vertices[corner]]);
    const DVec3 next(mesh.positions[face.vertices[(corner + 1) % 3]]);
    const DVec3 previous(mesh.positions[face.vertices[(corner + 2) % 3]]);
    const double cosine = dot(flattened(next - here, normal), flattened(previous - here, normal));
    sum += std::acos(std::clamp(cosine, -1.0, 1.0)) * flattened(face.along_u, normal);
  }
  const DVec3 tangent = normalize_or_zero(sum);
  const Vec3 unit = tangent == DVec3(0.0) ? geometry::make_frame(mesh.normals[group.vertex]).tangent
                                          : Vec3(tangent);
  return {unit, group.keeps_orientation ? 1.0f : -1.0f};
}

/// Gives each corner of each triangle its tangent; splits vertices.
class VertexSplitter {
 public:
  explicit VertexSplitter(Mesh& mesh) : mesh_(mesh), has_tangent_(mesh.positions.size(), false) {
    mesh_.tangents.reserve(mesh_.normals.size());
    for (const Vec3& normal : mesh_.normals) {
      mesh_.tangents.emplace_back(geometry::make_frame(normal).tangent, 1.0f);
    }
  }

  /// The vertex that is like `vertex` and has the tangent.
  std::uint32_t with_tangent(std::uint32_t vertex, const Vec4& tangent) {
    if (!has_tangent_[vertex]) {
      has_tangent_[vertex] = true;
      mesh_.tangents[vertex] = tangent;
    }
    if (mesh_.tangents[vertex] == tangent) {
      return vertex;
    }
    const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
    const auto [it, is_new] = copies_.try_emplace(
        {vertex, bits(tangent.x), bits(tangent.y), bits(tangent.z), bits(tangent.w)},
        static_cast<std::uint32_t>(mesh_.positions.size()));
    if (is_new) {
      append_copy(vertex, tangent);
    }
    return it->second;
  }

  [[nodiscard]] std::vector<std::uint32_t> sources() && { return std::move(sources_); }

 private:
  template <class T>
  static void repeat(std::vector<T>& values, std::uint32_t vertex) {
    if (!values.empty()) {
      const T value = values[vertex];
      values.push_back(value);
    }
  }

  void append_copy(std::uint32_t vertex, const Vec4& tangent) {
    repeat(mesh_.positions, vertex);
    repeat(mesh_.normals, vertex);
    repeat(mesh_.colors, vertex);
    for (auto& set : mesh_.texcoords) {
      repeat(set, vertex);
    }
    mesh_.tangents.push_back(tangent);
    sources_.push_back(vertex);
  }

  Mesh& mesh_;
  std::vector<bool> has_tangent_;  ///< of the vertices there were, whether a corner gave one
  std::map<std::array<std::uint32_t, 5>, std::uint32_t> copies_;  ///< by vertex and tangent
  std::vector<std::uint32_t> sources_;
};

}  // namespace

std::vector<std::uint32_t> generate_tangents(Mesh& mesh, std::size_t set) {
  TangentFaces faces = make_tangent_faces(mesh, set);
  const std::vector<TangentGroup> groups = group_corners(faces);
  std::vector<Vec4> tangents;
  tangents.reserve(groups.size());
  for (const TangentGroup& group : groups) {
    tangents.push_back(group_tangent(mesh, faces, group));
  }
  VertexSplitter splitter(mesh);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (int c = 0; c < 3; ++c) {
      if (const std::uint32_t group = faces[f].groups[static_cast<std::size_t>(c)];
          group != TangentFace::k_none) {
        mesh.triangles[f][c] = splitter.with_tangent(mesh.triangles[f][c], tangents[group]);
      }
    }
  }
  return std::move(splitter).sources();
}

}  // namespace lume::io::gltf
