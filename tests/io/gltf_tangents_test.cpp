// SPDX-License-Identifier: Apache-2.0
// Which meshes are given tangents; and real files that come with some ($LUME_TEST_DATA): ours are
// held against theirs.
#include "io/gltf/load_gltf.h"
#include "io/gltf/tangents.h"
#include "tests/support/gltf_file.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

namespace lume::io {
namespace {

using geometry::Mesh;
using geometry::Vec3;
using geometry::Vec4;

/// How many corners of triangles there are, and how many of them have the file's tangent.
struct Agreement {
  std::size_t corners = 0;
  std::size_t within_one_degree = 0;
  std::size_t same_handedness = 0;
};

void compare(const Mesh& given, Agreement& agreement) {
  Mesh made = given;
  made.tangents.clear();
  gltf::generate_tangents(made, 0);
  const float limit = std::cos(geometry::k_pi / 180.0f);
  for (std::size_t t = 0; t < given.triangles.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const Vec4& theirs = given.tangents[given.triangles[t][c]];
      const Vec4& ours = made.tangents[made.triangles[t][c]];
      ++agreement.corners;
      agreement.within_one_degree += dot(Vec3(theirs), Vec3(ours)) > limit ? 1 : 0;
      agreement.same_handedness += theirs.w == ours.w ? 1 : 0;
    }
  }
}

struct Model {
  const char* path;
  double share;  ///< of corners, at least, that agree within one degree
};

class GltfTangents : public testing::TestWithParam<Model> {};

TEST_P(GltfTangents, TangentsOfTheFile_AreMadeAgain) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "LUME_TEST_DATA is not set";
  const LoadedScene loaded =
      load_gltf(*data / "gltf/assets" / GetParam().path, {.decode_images = false});
  Agreement agreement;
  for (const geometry::Object& object : loaded.scene.world.objects) {
    for (const geometry::Geometry& geometry : object.geometries) {
      if (const Mesh* mesh = geometry.mesh(); mesh != nullptr && !mesh->tangents.empty()) {
        compare(*mesh, agreement);
      }
    }
  }
  const auto corners = static_cast<double>(agreement.corners);
  ASSERT_GT(agreement.corners, 0u);
  EXPECT_GE(static_cast<double>(agreement.within_one_degree) / corners, GetParam().share);
  EXPECT_GE(static_cast<double>(agreement.same_handedness) / corners, GetParam().share);
}

INSTANTIATE_TEST_SUITE_P(
    Models, GltfTangents,
    testing::Values(Model{"NormalTangentMirrorTest/glTF-Binary/NormalTangentMirrorTest.glb", 1.0},
                    Model{"SheenCloth/glTF/SheenCloth.gltf", 1.0},
                    Model{"LightsPunctualLamp/glTF/LightsPunctualLamp.gltf", 0.995}),
    [](const auto& test) {
      const std::string path = test.param.path;
      return path.substr(0, path.find('/'));
    });

/// The triangle with normals and this normal texture.
Mesh load_with(const nlohmann::json& normal_texture) {
  test::GltfFile file = test::triangle_file();
  const std::size_t normals = file.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
  file.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = normals;
  if (!normal_texture.is_null()) file.json["materials"][0]["normalTexture"] = normal_texture;
  const tests::TemporaryFolder folder;
  const LoadedScene loaded = load_gltf(file.write(folder / "a.gltf"));
  return *loaded.scene.world.objects.at(0).geometries.at(0).mesh();
}

TEST(GltfMadeTangents, NormalTexture_AsksForThem) {
  const std::vector<Vec4> expected(3, Vec4(1.0f, 0.0f, 0.0f, -1.0f));
  EXPECT_EQ(load_with({{"index", 0}}).tangents, expected);
  EXPECT_TRUE(load_with(nullptr).tangents.empty());
  EXPECT_TRUE(load_with({{"index", 0}, {"texCoord", 1}}).tangents.empty());
}

TEST(GltfMadeTangents, TurnedOrMirroredTexture_GetsNone) {
  const auto load_transformed = [](const nlohmann::json& transform) {
    return load_with({{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}});
  };
  EXPECT_FALSE(load_transformed({{"scale", {2.0, 3.0}}}).tangents.empty());
  EXPECT_TRUE(load_transformed({{"rotation", 0.5}}).tangents.empty());
  EXPECT_TRUE(load_transformed({{"scale", {-1.0, 1.0}}}).tangents.empty());
}

}  // namespace
}  // namespace lume::io
