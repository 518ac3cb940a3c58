// SPDX-License-Identifier: Apache-2.0
#include "io/error.h"
#include "io/gltf/load_gltf.h"
#include "io/gltf/triangulate.h"
#include "tests/support/gltf_file.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace lume::io {
namespace {

using geometry::Mesh;
using geometry::UVec3;
using geometry::Vec2;
using geometry::Vec3;
using geometry::Vec4;
using gltf::Mode;
using test::GltfFile;
using testing::ElementsAre;
using testing::HasSubstr;

/// A mesh of one primitive with these positions on one node.
GltfFile mesh_file(const std::vector<float>& positions) {
  GltfFile file;
  const std::size_t accessor = file.add_floats(positions, "VEC3", 3);
  file.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", accessor}}}}}}});
  file.add("nodes", {{"mesh", 0}});
  return file;
}

nlohmann::json& primitive(GltfFile& file) { return file.json["meshes"][0]["primitives"][0]; }

LoadedScene load(const GltfFile& file) {
  const tests::TemporaryFolder folder;
  return load_gltf(file.write(folder / "a.gltf"));
}

Mesh load_mesh(const GltfFile& file) {
  return *load(file).scene.world.objects.at(0).geometries.at(0).mesh();
}

const std::vector<float> k_triangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};

TEST(GltfTriangulate, Strip_AlternatesWinding) {
  EXPECT_THAT(gltf::triangulate(5, Mode::triangle_strip),
              ElementsAre(UVec3(0, 1, 2), UVec3(1, 3, 2), UVec3(2, 3, 4)));
}

TEST(GltfTriangulate, Fan_SharesFirstVertex) {
  const std::vector<std::uint32_t> indices = {9, 4, 5, 6};
  EXPECT_THAT(gltf::triangulate(indices, Mode::triangle_fan),
              ElementsAre(UVec3(4, 5, 9), UVec3(5, 6, 9)));
}

TEST(GltfTriangulate, IncompleteTriangles_AreLeftOut) {
  for (const Mode mode : {Mode::triangles, Mode::triangle_strip, Mode::triangle_fan}) {
    for (std::uint32_t count = 0; count < 3; ++count) {
      EXPECT_TRUE(gltf::triangulate(count, mode).empty());
    }
  }
  EXPECT_EQ(gltf::triangulate(8, Mode::triangles).size(), 2u);
}

/// A regular polygon around +z, as a strip (zigzag) or as a fan, must face +z everywhere.
TEST(GltfTriangulate, ConvexPolygon_FacesOneWay) {
  constexpr std::uint32_t k_corners = 9;
  std::vector<std::uint32_t> zigzag;
  for (std::uint32_t i = 0; i < k_corners; ++i) {
    zigzag.push_back(i % 2 == 0 ? i / 2 : k_corners - 1 - i / 2);
  }
  // 0, 8, 1, 7 ... starts clockwise: reversed roles of the first two turn it round.
  for (std::uint32_t& corner : zigzag) corner = k_corners - 1 - corner;
  const auto position = [](std::uint32_t corner) {
    const float angle = 2.0f * geometry::k_pi * static_cast<float>(corner) / k_corners;
    return Vec3(std::cos(angle), std::sin(angle), 0.0f);
  };
  auto triangles = gltf::triangulate(zigzag, Mode::triangle_strip);
  const auto fan = gltf::triangulate(k_corners, Mode::triangle_fan);
  triangles.insert(triangles.end(), fan.begin(), fan.end());
  EXPECT_EQ(triangles.size(), 2u * (k_corners - 2));
  for (const UVec3& t : triangles) {
    const Vec3 a = position(t.x);
    EXPECT_GT(cross(position(t.y) - a, position(t.z) - a).z, 0.0f);
  }
}

TEST(GltfMesh, WithoutIndices_UsesVertexOrder) {
  const Mesh mesh = load_mesh(mesh_file(k_triangle));
  EXPECT_THAT(mesh.triangles, ElementsAre(UVec3(0, 1, 2)));
  EXPECT_TRUE(mesh.normals.empty());
}

TEST(GltfMesh, RestartIndex_IsErrorWithPointer) {
  GltfFile file = mesh_file(k_triangle);
  primitive(file)["indices"] = file.add_accessor<std::uint8_t>({0, 1, 255}, 5121, "SCALAR", 1);
  EXPECT_THAT([&] { load(file); },
              testing::ThrowsMessage<Error>(HasSubstr("/meshes/0/primitives/0/indices: index 2")));
}

TEST(GltfMesh, PositionNotFinite_IsErrorWithPointer) {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e20f}) {
    const GltfFile file = mesh_file({0, 0, 0, 1, bad, 0, 0, 1, 0});
    EXPECT_THAT([&] { load(file); },
                testing::ThrowsMessage<Error>(HasSubstr("POSITION: element 1")));
  }
}

TEST(GltfMesh, PointsAndLines_AreNotedNotDrawn) {
  for (int mode = 0; mode < 4; ++mode) {
    GltfFile file = mesh_file(k_triangle);
    primitive(file)["mode"] = mode;
    const LoadedScene loaded = load(file);
    EXPECT_TRUE(loaded.scene.world.instances.empty());
    EXPECT_THAT(loaded.notes, ElementsAre(mode == 0 ? "mesh 0 primitive 0: points are not drawn"
                                                    : "mesh 0 primitive 0: lines are not drawn"));
  }
}

TEST(GltfMesh, WithoutPositions_IsNotedNotDrawn) {
  GltfFile file = mesh_file(k_triangle);
  primitive(file)["attributes"] = {{"NORMAL", 0}};
  const LoadedScene loaded = load(file);
  EXPECT_TRUE(loaded.scene.world.objects.empty());
  EXPECT_THAT(loaded.notes, ElementsAre(HasSubstr("no POSITION")));
}

TEST(GltfMesh, Normals_BecomeUnitOrAreRepaired) {
  GltfFile file = mesh_file(k_triangle);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  primitive(file)["attributes"]["NORMAL"] =
      file.add_floats({0, 3, 4, 0, 0, 0, nan, 1, 0}, "VEC3", 3);
  primitive(file)["attributes"]["TANGENT"] =
      file.add_floats({2, 0, 0, -1, 0, 0, 0, 1, 0, 1, 0, 0.5f}, "VEC4", 4);
  const Mesh mesh = load_mesh(file);
  EXPECT_THAT(mesh.normals, ElementsAre(Vec3(0, 0.6f, 0.8f), Vec3(0, 0, 1), Vec3(0, 0, 1)));
  EXPECT_EQ(mesh.tangents[0], Vec4(1, 0, 0, -1));
  EXPECT_FLOAT_EQ(length(Vec3(mesh.tangents[1])), 1.0f);
  EXPECT_NEAR(dot(Vec3(mesh.tangents[1]), mesh.normals[1]), 0.0f, 1e-6f);
  EXPECT_EQ(mesh.tangents[2], Vec4(0, 1, 0, 1));
  EXPECT_THAT(load(file).notes, ElementsAre(HasSubstr("normals")));
}

TEST(GltfMesh, TangentsWithoutNormals_AreIgnored) {
  GltfFile file = mesh_file(k_triangle);
  primitive(file)["attributes"]["TANGENT"] =
      file.add_floats({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4", 4);
  EXPECT_TRUE(load_mesh(file).tangents.empty());
}

TEST(GltfMesh, TexcoordSets_KeepTheirNumbers) {
  GltfFile file = mesh_file(k_triangle);
  primitive(file)["attributes"]["TEXCOORD_2"] =
      file.add_accessor<std::uint16_t>({0, 65535, 0, 0, 65535, 0}, 5123, "VEC2", 2);
  file.json["accessors"].back()["normalized"] = true;
  const Mesh mesh = load_mesh(file);
  ASSERT_EQ(mesh.texcoords.size(), 3u);
  EXPECT_TRUE(mesh.texcoords[0].empty());
  EXPECT_TRUE(mesh.texcoords[1].empty());
  EXPECT_THAT(mesh.texcoords[2], ElementsAre(Vec2(0, 1), Vec2(0, 0), Vec2(1, 0)));
}

TEST(GltfMesh, ColorsWithoutAlpha_AreOpaque) {
  GltfFile file = mesh_file(k_triangle);
  primitive(file)["attributes"]["COLOR_0"] =
      file.add_floats({1, 0, 0, 0, 0.5f, 0, 0, -1, 2}, "VEC3", 3);
  EXPECT_THAT(load_mesh(file).colors,
              ElementsAre(Vec4(1, 0, 0, 1), Vec4(0, 0.5f, 0, 1), Vec4(0, 0, 1, 1)));
}

TEST(GltfMesh, QuantizedPositions_KeepTheirIntegers) {
  GltfFile file;
  file.add_accessor<std::int16_t>({0, 0, -300, 0, 30000, 0, 0, 0, 0, 7, 0, 0}, 5122, "VEC3", 4);
  file.json["bufferViews"][0]["byteStride"] = 8;
  file.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}});
  file.add("nodes", {{"mesh", 0}});
  EXPECT_THAT(load_mesh(file).positions,
              ElementsAre(Vec3(0, 0, -300), Vec3(30000, 0, 0), Vec3(0, 7, 0)));
}

TEST(GltfMesh, NoMaterial_UsesDefaultOfGltf) {
  GltfFile file = test::triangle_file();
  primitive(file).erase("material");
  const LoadedScene loaded = load(file);
  ASSERT_EQ(loaded.scene.materials.size(), 2u);
  EXPECT_EQ(loaded.scene.world.objects[0].geometries[0].material, 1u);
  EXPECT_EQ(loaded.scene.materials[1].roughness, 1.0f);
}

TEST(GltfMesh, Holes_NeedMaskAndSomethingThatVaries) {
  const auto has_holes = [](double alpha, bool textured, const char* mode) {
    GltfFile file = test::triangle_file();
    nlohmann::json& material = file.json["materials"][0];
    material["alphaMode"] = mode;
    if (!textured) material["pbrMetallicRoughness"].erase("baseColorTexture");
    material["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, alpha};
    return load(file).scene.world.objects.at(0).geometries.at(0).has_holes;
  };
  EXPECT_TRUE(has_holes(1.0, true, "MASK"));
  EXPECT_TRUE(has_holes(0.4, false, "MASK"));
  EXPECT_FALSE(has_holes(0.6, false, "MASK"));
  EXPECT_FALSE(has_holes(0.4, true, "BLEND"));
  EXPECT_FALSE(has_holes(0.4, true, "OPAQUE"));
}

TEST(GltfMesh, SharedByNodes_IsOneObject) {
  GltfFile file = mesh_file(k_triangle);
  file.add("nodes", {{"mesh", 0}, {"name", "second"}, {"translation", {5, 0, 0}}});
  const LoadedScene loaded = load(file);
  EXPECT_EQ(loaded.scene.world.objects.size(), 1u);
  ASSERT_EQ(loaded.scene.world.instances.size(), 2u);
  EXPECT_EQ(loaded.scene.world.instances[0].name, "node 0");
  EXPECT_EQ(loaded.scene.world.instances[1].name, "second");
}

TEST(GltfMesh, SameNoteOfMany_IsOneLine) {
  GltfFile file = mesh_file(k_triangle);
  primitive(file)["mode"] = 1;
  for (int i = 0; i < 41; ++i) file.json["meshes"][0]["primitives"].push_back(primitive(file));
  EXPECT_THAT(load(file).notes, ElementsAre("mesh 0 primitive 0 and 41 more: lines are not drawn"));
}

}  // namespace
}  // namespace lume::io
