// SPDX-License-Identifier: Apache-2.0
// KHR_draco_mesh_compression: meshes that were compressed come back, what contradicts its accessors
// is refused, and damage does no harm.
#include "geometry/parallel.h"
#include "tests/io/draco_encoder.h"
#include "tests/io/gltf_guard.h"
#include "tests/support/cases.h"
#include "tests/support/memory_limit.h"
#include "tests/support/random.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>

namespace lume::io {
namespace {

using geometry::Mesh;
using geometry::UVec3;
using geometry::Vec2;
using geometry::Vec3;
using geometry::Vec4;

/// All that a corner has, for comparing triangles whose vertices were put in another order.
using Corner = std::array<float, 12>;
using Triangles = std::vector<std::array<Corner, 3>>;

/// A bumpy sheet with holes, normals, texture coordinates, and colours in eighths of 255.
Mesh random_sheet(test::Random& random) {
  Mesh mesh;
  const std::uint32_t width = 4 + random.below(8);
  const std::uint32_t height = 4 + random.below(8);
  mesh.texcoords.resize(1);
  for (std::uint32_t i = 0; i < width * height; ++i) {
    const Vec2 uv(static_cast<float>(i % width), static_cast<float>(i / width));
    mesh.positions.emplace_back(uv.x, uv.y, random.uniform());
    mesh.normals.push_back(random.upper_direction());
    mesh.texcoords[0].push_back(uv / 8.0f);
    mesh.colors.emplace_back(uv / 15.0f, 1.0f, 0.2f);
    if (i % width == 0 || i < width || random.below(6) == 0) continue;
    mesh.triangles.emplace_back(i, i - 1, i - width);
    mesh.triangles.emplace_back(i - 1, i - width - 1, i - width);
  }
  return mesh;
}

Triangles triangles_of(const Mesh& mesh) {
  Triangles result;
  for (const UVec3& indices : mesh.triangles) {
    std::array<Corner, 3> triangle{};
    for (int c = 0; c < 3; ++c) {
      const std::uint32_t i = indices[c];
      const Vec3& p = mesh.positions[i];
      const Vec3& n = mesh.normals[i];
      const Vec2& uv = mesh.texcoords[0][i];
      const Vec4 rgba = round(mesh.colors[i] * 255.0f);
      triangle[static_cast<std::size_t>(c)] = {p.x,  p.y,  p.z,    n.x,    n.y,    n.z,
                                               uv.x, uv.y, rgba.x, rgba.y, rgba.z, rgba.w};
    }
    // The codec may turn a triangle.
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
    result.push_back(triangle);
  }
  std::sort(result.begin(), result.end());
  return result;
}

Mesh load(const test::GltfFile& file) {
  const tests::TemporaryFolder folder;
  return *load_gltf(file.write(folder / "a.gltf"))
              .scene.world.objects.at(0)
              .geometries.at(0)
              .mesh();
}

Mesh unit_normals(Mesh mesh) {
  for (Vec3& normal : mesh.normals) {
    normal = Vec3(geometry::DVec3(normal) / length(geometry::DVec3(normal)));
  }
  return mesh;
}

class GltfDraco : public testing::TestWithParam<draco::MeshEncoderMethod> {};

TEST_P(GltfDraco, Sheets_ComeBackExactly) {
  test::Random random(1);
  for (int i = 0; i < test::cases(150); ++i) {
    const Mesh mesh = random_sheet(random);
    EXPECT_EQ(triangles_of(load(test::compress(mesh, GetParam()).file)),
              triangles_of(unit_normals(mesh)));
  }
}

TEST_P(GltfDraco, Damage_EndsInAnErrorWithoutMuchMemory) {
  const geometry::ThreadLimit one_thread(1);
  test::Random random(2);
  const test::CompressedFile good = test::compress(random_sheet(random), GetParam());
  static_cast<void>(load(good.file));
  const test::MemoryLimit limit(std::size_t{1} << 30);
  int refused = 0;
  for (int i = 0; i < test::cases(400); ++i) {
    test::CompressedFile bad = good;
    for (std::uint32_t flips = 1 + random.below(3); flips > 0; --flips) {
      const std::uint32_t at = random.below(static_cast<std::uint32_t>(bad.size));
      bad.file.bytes[bad.offset + at] ^= static_cast<std::uint8_t>(1u << random.below(8));
    }
    try {
      static_cast<void>(load(bad.file));
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("bad_alloc")));
      EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("\n")));
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

INSTANTIATE_TEST_SUITE_P(Methods, GltfDraco,
                         testing::Values(draco::MESH_SEQUENTIAL_ENCODING,
                                         draco::MESH_EDGEBREAKER_ENCODING),
                         [](const auto& test) {
                           return test.param == draco::MESH_SEQUENTIAL_ENCODING ? "Sequential"
                                                                                : "Edgebreaker";
                         });

test::CompressedFile example() {
  test::Random random(3);
  return test::compress(random_sheet(random), draco::MESH_SEQUENTIAL_ENCODING);
}

TEST(GltfDracoFile, AttributeOutsideTheExtension_IsItsAccessor) {
  test::CompressedFile example = io::example();
  const Mesh all = load(example.file);
  std::vector<float> texcoords;
  for (std::size_t i = 0; i < 2 * all.positions.size(); ++i) {
    texcoords.push_back(static_cast<float>(i));
  }
  const std::size_t accessor = example.file.add_floats(texcoords, "VEC2", 2);
  auto& primitive = example.file.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["TEXCOORD_0"] = accessor;
  primitive["extensions"]["KHR_draco_mesh_compression"]["attributes"].erase("TEXCOORD_0");
  const Mesh mesh = load(example.file);
  EXPECT_EQ(mesh.positions, all.positions);
  for (std::size_t i = 0; i < all.positions.size(); ++i) {
    EXPECT_EQ(mesh.texcoords[0][i], Vec2(2 * i, 2 * i + 1));
  }
}

TEST(GltfDracoFile, Strip_HasTheFacesOfTheCompressedMesh) {
  test::CompressedFile example = io::example();
  const Mesh mesh = load(example.file);
  example.file.json["meshes"][0]["primitives"][0]["mode"] = 5;
  EXPECT_EQ(load(example.file).triangles, mesh.triangles);
}

TEST(GltfDracoFile, CompressedDataBesideFallback_AreUsed) {
  test::CompressedFile example = io::example();
  const Mesh mesh = load(example.file);
  const std::size_t zeros =
      example.file.add_view(std::vector<float>(3 * mesh.positions.size(), 0.0f));
  example.file.json["accessors"][0]["bufferView"] = zeros;
  EXPECT_EQ(load(example.file).positions, mesh.positions);
}

/// Bytes where Draco's format has its version, type and method, behind the word DRACO.
TEST(GltfDracoFile, OtherHeader_IsRefused) {
  for (const auto& [at, value] : {std::pair{0, 'X'}, {5, '\1'}, {6, '\3'}, {7, '\0'}, {8, '\7'}}) {
    test::CompressedFile bad = example();
    bad.file.bytes[bad.offset + static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(value);
    test::expect_scene_error(bad.file.complete(),
                             "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression");
  }
}

/// A header that announces millions of faces, with indices that agree.
TEST(GltfDracoFile, FacesThatCannotBe_AllocateNothing) {
  const test::MemoryLimit limit(std::size_t{1} << 28);
  test::CompressedFile bad = example();
  bad.file.bytes.resize(bad.offset + 11);
  constexpr std::uint32_t k_faces = 32000000;
  for (std::uint32_t rest = k_faces; rest > 0; rest >>= 7) {
    bad.file.bytes.push_back(static_cast<std::uint8_t>((rest & 127u) | (rest > 127 ? 128u : 0u)));
  }
  bad.file.bytes.resize(bad.offset + 64);
  bad.file.json["bufferViews"][0]["byteLength"] = 64;
  bad.file.json["accessors"][4]["count"] = 3 * k_faces;
  test::expect_scene_error(bad.file.complete(),
                           "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression");
}

class GltfDracoGuard : public testing::TestWithParam<test::GuardCase> {};

TEST_P(GltfDracoGuard, BrokenFile_IsSceneErrorWithPointer) {
  test::expect_scene_error(example().file.complete().patch(nlohmann::json::parse(GetParam().patch)),
                           GetParam().pointer);
}

constexpr test::GuardCase k_cases[] = {
    {"NoView",
     R"([{"op":"remove","path":"/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/bufferView"}])",
     "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression"},
    {"NoSuchView",
     R"([{"op":"replace","path":"/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/bufferView","value":7}])",
     "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/bufferView"},
    {"NoAttributes",
     R"([{"op":"remove","path":"/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/attributes"}])",
     "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression"},
    {"NoSuchId",
     R"([{"op":"replace","path":"/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/attributes/NORMAL","value":77}])",
     "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression"},
    {"HugeId",
     R"([{"op":"replace","path":"/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/attributes/NORMAL","value":4294967296}])",
     "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression"},
    {"NegativeId",
     R"([{"op":"replace","path":"/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/attributes/NORMAL","value":-1}])",
     "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/attributes/NORMAL"},
    {"AttributeOfNobody",
     R"([{"op":"add","path":"/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/attributes/TANGENT","value":1}])",
     "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/attributes/TANGENT"},
    {"OtherWidth",
     R"([{"op":"replace","path":"/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/attributes/NORMAL","value":2}])",
     "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression"},
    {"PointsMode", R"([{"op":"add","path":"/meshes/0/primitives/0/mode","value":0}])",
     "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression"},
    {"FanMode", R"([{"op":"add","path":"/meshes/0/primitives/0/mode","value":6}])",
     "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression"},
    {"OtherNumberOfIndices", R"([{"op":"replace","path":"/accessors/4/count","value":3}])",
     "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression"},
    {"IndicesNotOfTriangles", R"([{"op":"replace","path":"/accessors/4/count","value":4}])",
     "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression"},
    {"OtherNumberOfVertices", R"([{"op":"replace","path":"/accessors/1/count","value":3}])",
     "/meshes/0/primitives/0/attributes/NORMAL"},
    {"FloatsAsBytes", R"([{"op":"replace","path":"/accessors/0/componentType","value":5121}])",
     "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression"},
    {"Truncated", R"([{"op":"replace","path":"/bufferViews/0/byteLength","value":40}])",
     "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression"},
    {"Empty", R"([{"op":"replace","path":"/bufferViews/0/byteLength","value":0}])",
     "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression"},
};

INSTANTIATE_TEST_SUITE_P(Rules, GltfDracoGuard, testing::ValuesIn(k_cases), test::case_name);

}  // namespace
}  // namespace lume::io
