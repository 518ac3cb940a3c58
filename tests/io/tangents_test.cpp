// SPDX-License-Identifier: Apache-2.0
// Tangents against closed forms, and symmetries that they must keep.
#include "io/gltf/tangents.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace lume::io::gltf {
namespace {

using geometry::k_pi;
using geometry::Mesh;
using geometry::UVec3;
using geometry::Vec2;
using geometry::Vec3;
using geometry::Vec4;

/// A point of a surface over (u, v), with its normal and the direction in which u grows.
struct Point {
  Vec3 position;
  Vec3 normal;
  Vec3 along_u;
};
using Surface = std::function<Point(Vec2)>;

Point torus(Vec2 uv) {
  const float a = 2.0f * k_pi * uv.x;
  const float b = 2.0f * k_pi * uv.y;
  const Vec3 out(std::cos(a), std::sin(a), 0.0f);
  const Vec3 normal = std::cos(b) * out + Vec3(0.0f, 0.0f, std::sin(b));
  return {2.0f * out + 0.5f * normal, normal, Vec3(-std::sin(a), std::cos(a), 0.0f)};
}

/// Without its poles.
Point sphere(Vec2 uv) {
  const float a = 2.0f * k_pi * uv.x;
  const float b = k_pi * (0.1f + 0.8f * uv.y);
  const Vec3 normal(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b));
  return {normal, normal, Vec3(-std::sin(a), std::cos(a), 0.0f)};
}

/// A sheared plane, on which u and v do not meet at right angles.
Point plane(Vec2 uv) {
  return {Vec3(uv.x + 0.5f * uv.y, 2.0f * uv.y, 1.0f), Vec3(0.0f, 0.0f, 1.0f),
          Vec3(1.0f, 0.0f, 0.0f)};
}

constexpr std::uint32_t k_cells = 32;

/// Cells of two triangles over the unit square.
Mesh tessellate(const Surface& surface) {
  Mesh mesh;
  mesh.texcoords.resize(1);
  constexpr std::uint32_t k_row = k_cells + 1;
  for (std::uint32_t i = 0; i < k_row * k_row; ++i) {
    const Vec2 uv = Vec2(i % k_row, i / k_row) / static_cast<float>(k_cells);
    const Point point = surface(uv);
    mesh.positions.push_back(point.position);
    mesh.normals.push_back(point.normal);
    mesh.texcoords[0].push_back(uv);
    if (i % k_row == 0 || i < k_row) continue;
    mesh.triangles.emplace_back(i - k_row - 1, i - k_row, i);
    mesh.triangles.emplace_back(i - k_row - 1, i, i - 1);
  }
  return mesh;
}

float cosine(const Vec3& a, const Vec3& b) { return dot(a, b) / (length(a) * length(b)); }

/// The tangents of all corners of all triangles.
std::vector<Vec4> corner_tangents(const Mesh& mesh) {
  std::vector<Vec4> result;
  for (const UVec3& triangle : mesh.triangles) {
    for (int c = 0; c < 3; ++c) result.push_back(mesh.tangents[triangle[c]]);
  }
  return result;
}

std::vector<Vec4> generate(Mesh mesh) {
  generate_tangents(mesh, 0);
  return corner_tangents(mesh);
}

void expect_near(const std::vector<Vec4>& actual, const std::vector<Vec4>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_LT(length(actual[i] - expected[i]), 1e-5f) << i;
  }
}

TEST(Tangents, SmoothSurfaces_FollowTheirParameter) {
  for (const Surface& surface : {Surface(torus), Surface(sphere), Surface(plane)}) {
    Mesh mesh = tessellate(surface);
    const std::vector<std::uint32_t> copies = generate_tangents(mesh, 0);
    EXPECT_TRUE(copies.empty());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const Point point = surface(mesh.texcoords[0][i]);
      // An edge of the tessellation turns by half a cell, which at the border nothing balances.
      EXPECT_GT(cosine(Vec3(mesh.tangents[i]), point.along_u), std::cos(1.01f * k_pi / k_cells));
      EXPECT_NEAR(dot(Vec3(mesh.tangents[i]), mesh.normals[i]), 0.0f, 1e-6f);
      EXPECT_NEAR(length(Vec3(mesh.tangents[i])), 1.0f, 1e-6f);
    }
  }
}

/// cross(normal, tangent) * w points where v falls, upward in the image.
TEST(Tangents, Handedness_PointsUpInTheImage) {
  for (const bool mirrored : {false, true}) {
    const auto surface = [&](Vec2 uv) { return plane({mirrored ? -uv.x : uv.x, uv.y}); };
    Mesh mesh = tessellate(surface);
    if (mirrored) {
      for (UVec3& t : mesh.triangles) std::swap(t.y, t.z);
    }
    generate_tangents(mesh, 0);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const Vec4 t = mesh.tangents[i];
      EXPECT_LT(dot(cross(mesh.normals[i], Vec3(t)) * t.w, Vec3(0.5f, 2.0f, 0.0f)), 0.0f);
      EXPECT_EQ(t.w, mirrored ? 1.0f : -1.0f);
    }
  }
}

/// u runs up to the middle and back: the vertices there are split, for the tangent must not vanish.
TEST(Tangents, MirroredHalves_SplitTheirSeam) {
  Mesh mesh = tessellate(plane);
  mesh.colors.assign(mesh.positions.size(), Vec4(0.5f));
  mesh.colors[k_cells / 2] = Vec4(0.25f);
  for (Vec2& uv : mesh.texcoords[0]) uv.x = std::abs(uv.x - 0.5f);
  const std::size_t before = mesh.positions.size();
  const std::vector<std::uint32_t> copies = generate_tangents(mesh, 0);
  EXPECT_EQ(copies.size(), k_cells + 1u);
  ASSERT_EQ(mesh.positions.size(), before + copies.size());
  for (std::size_t i = 0; i < copies.size(); ++i) {
    const std::uint32_t source = copies[i];
    EXPECT_EQ(source % (k_cells + 1), k_cells / 2);
    EXPECT_EQ(mesh.positions[before + i], mesh.positions[source]);
    EXPECT_EQ(mesh.normals[before + i], mesh.normals[source]);
    EXPECT_EQ(mesh.texcoords[0][before + i], mesh.texcoords[0][source]);
    EXPECT_EQ(mesh.colors[before + i], mesh.colors[source]);
    EXPECT_EQ(mesh.tangents[before + i], -mesh.tangents[source]);
  }
  for (const UVec3& triangle : mesh.triangles) {
    const Vec3 sum =
        mesh.positions[triangle.x] + mesh.positions[triangle.y] + mesh.positions[triangle.z];
    const float side = sum.x - 0.25f * sum.y > 1.5f ? 1.0f : -1.0f;
    for (int c = 0; c < 3; ++c) {
      EXPECT_LT(length(mesh.tangents[triangle[c]] - Vec4(side, 0.0f, 0.0f, -side)), 1e-5f);
    }
  }
}

/// A bumpy sheet whose texture coordinates are drawn in all directions, mirrored here and there.
Mesh random_mesh(test::Random& random) {
  Mesh mesh = tessellate([&](Vec2 uv) {
    return Point{
        Vec3(uv + 0.01f * random.square(), 0.05f * random.uniform()), random.upper_direction(), {}};
  });
  for (Vec2& uv : mesh.texcoords[0])
    uv = 0.3f * random.square() + Vec2(uv.y, std::abs(uv.x - 0.4f));
  return mesh;
}

template <class T>
void shuffle(std::vector<T>& values, test::Random& random) {
  for (std::size_t i = values.size(); i > 1; --i) {
    std::swap(values[i - 1], values[random.below(static_cast<std::uint32_t>(i))]);
  }
}

TEST(Tangents, OrderOfTriangles_IsOfNoMatter) {
  test::Random random(1);
  for (int run = 0; run < 5; ++run) {
    const Mesh mesh = random_mesh(random);
    std::vector<std::size_t> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    shuffle(order, random);
    Mesh other = mesh;
    for (std::size_t i = 0; i < order.size(); ++i) other.triangles[i] = mesh.triangles[order[i]];
    const std::vector<Vec4> expected = generate(mesh);
    const std::vector<Vec4> actual = generate(other);
    std::vector<Vec4> sorted(actual.size());
    for (std::size_t i = 0; i < actual.size(); ++i) sorted[3 * order[i / 3] + i % 3] = actual[i];
    expect_near(sorted, expected);
  }
}

/// Corners that each have a vertex of their own are welded first.
TEST(Tangents, VerticesOfTheirOwn_AreWelded) {
  test::Random random(2);
  const Mesh mesh = random_mesh(random);
  Mesh soup;
  soup.texcoords.resize(1);
  for (const UVec3& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (int c = 0; c < 3; ++c) {
      soup.positions.push_back(mesh.positions[triangle[c]]);
      soup.normals.push_back(mesh.normals[triangle[c]]);
      soup.texcoords[0].push_back(mesh.texcoords[0][triangle[c]]);
    }
    soup.triangles.emplace_back(first, first + 1, first + 2);
  }
  const auto expected = generate(mesh);
  EXPECT_TRUE(generate_tangents(soup, 0).empty());
  expect_near(corner_tangents(soup), expected);
}

TEST(Tangents, RotatedMesh_HasRotatedTangents) {
  test::Random random(3);
  for (int run = 0; run < 5; ++run) {
    const Mesh mesh = random_mesh(random);
    const geometry::Frame frame = geometry::make_frame(random.direction());
    Mesh turned = mesh;
    for (Vec3& p : turned.positions) p = frame.to_world(p);
    for (Vec3& n : turned.normals) n = frame.to_world(n);
    std::vector<Vec4> expected = generate(mesh);
    for (Vec4& t : expected) t = Vec4(frame.to_world(Vec3(t)), t.w);
    const std::vector<Vec4> actual = generate(turned);
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i) {
      EXPECT_LT(length(actual[i] - expected[i]), 1e-3f) << i;
    }
  }
}

/// Corners, edges and texture coordinates that fall together.
TEST(Tangents, DegenerateTriangles_HaveUnitTangents) {
  test::Random random(4);
  for (int run = 0; run < test::cases(300); ++run) {
    Mesh mesh;
    mesh.texcoords.resize(1);
    for (int i = 0; i < 12; ++i) {
      mesh.positions.emplace_back(random.below(2), random.below(2), random.below(2));
      mesh.normals.push_back(random.direction());
      mesh.texcoords[0].emplace_back(random.below(2), random.below(2));
    }
    for (int i = 0; i < 20; ++i) {
      mesh.triangles.emplace_back(random.below(12), random.below(12), random.below(12));
    }
    const std::vector<UVec3> before = mesh.triangles;
    generate_tangents(mesh, 0);
    ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
      EXPECT_NEAR(length(Vec3(mesh.tangents[i])), 1.0f, 1e-5f);
      EXPECT_EQ(std::abs(mesh.tangents[i].w), 1.0f);
    }
    for (std::size_t t = 0; t < before.size(); ++t) {
      for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(mesh.positions[mesh.triangles[t][c]], mesh.positions[before[t][c]]);
      }
    }
  }
}

/// A triangle without area takes the tangents of those that it lies among.
TEST(Tangents, DegenerateTriangle_TakesItsNeighboursTangents) {
  Mesh mesh = tessellate(plane);
  const std::uint32_t a = mesh.triangles[40].x;
  const std::uint32_t b = mesh.triangles[40].y;
  mesh.triangles.emplace_back(a, b, a);
  const std::vector<Vec4> corners = generate(mesh);
  for (std::size_t i = corners.size() - 3; i < corners.size(); ++i) {
    EXPECT_LT(length(corners[i] - Vec4(1.0f, 0.0f, 0.0f, -1.0f)), 1e-5f);
  }
}

/// Many triangles at one edge, and many groups at one vertex: time must not grow as their square.
TEST(Tangents, ManyTrianglesAtOnePlace_AreQuick) {
  test::Random random(5);
  Mesh mesh;
  mesh.texcoords.resize(1);
  const auto add = [&](const Vec3& position, Vec2 uv) {
    mesh.positions.push_back(position);
    mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
    mesh.texcoords[0].push_back(uv);
    return static_cast<std::uint32_t>(mesh.positions.size()) - 1;
  };
  const std::uint32_t a = add(Vec3(0.0f), Vec2(0.0f));
  const std::uint32_t b = add(Vec3(1.0f, 0.0f, 0.0f), Vec2(1.0f, 0.0f));
  for (int i = 0; i < test::cases(100000); ++i) {
    const std::uint32_t c = add(random.cube(1.0f), random.square());
    mesh.triangles.emplace_back(a, b, c);
    mesh.triangles.emplace_back(a, c, add(random.cube(1.0f), random.square()));
  }
  generate_tangents(mesh, 0);
  EXPECT_EQ(mesh.tangents.size(), mesh.positions.size());
}

}  // namespace
}  // namespace lume::io::gltf
