// SPDX-License-Identifier: Apache-2.0
// Where nodes put things.
#include "io/error.h"
#include "io/gltf/load_gltf.h"
#include "io/gltf/nodes.h"
#include "tests/support/gltf_file.h"
#include "tests/support/paths.h"
#include "tests/support/random.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lume::io {
namespace {

using geometry::DMat4;
using geometry::DVec3;
using geometry::Vec3;
using test::GltfFile;
using testing::ElementsAre;
using testing::HasSubstr;

LoadedScene load(const GltfFile& file, const LoadOptions& options = {}) {
  const tests::TemporaryFolder folder;
  return load_gltf(file.write(folder / "a.gltf"), options);
}

/// The triangle file with one node at its place.
GltfFile with_node(const nlohmann::json& node) {
  GltfFile file = test::triangle_file();
  file.json["nodes"] = nlohmann::json::array({node});
  file.json["scenes"] = {{{"nodes", {0}}}};
  return file;
}

/// The world position of the triangle's corner at x = 1.
DVec3 corner(const LoadedScene& loaded, std::size_t instance = 0) {
  const geometry::Instance& placed = loaded.scene.world.instances.at(instance);
  const geometry::Mesh& mesh = *loaded.scene.world.objects[placed.object].geometries[0].mesh();
  return loaded.scene.origin + placed.transform.point_to_world(DVec3(mesh.positions[1]));
}

void expect_near(const DVec3& a, const DVec3& b, double tolerance) {
  EXPECT_LE(length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(GltfNode, RotationScaleTranslation_ApplyInThatOrder) {
  const double s = std::sqrt(0.5);  // a quarter turn around z
  expect_near(corner(load(with_node({{"mesh", 0},
                                     {"translation", {10, 0, 0}},
                                     {"rotation", {0, 0, s, s}},
                                     {"scale", {3, 1, 1}}}))),
              {10, 3, 0}, 1e-12);
}

TEST(GltfNode, RandomTrs_EqualsItsMatrix) {
  test::Random random(11);
  for (int i = 0; i < 1000; ++i) {
    tinygltf::Node trs;
    const Vec3 axis = random.direction();
    const double angle = random.uniform(-3.0f, 3.0f);
    const DVec3 scale = DVec3(random.cube(2.0f)) + DVec3(2.5);
    const DVec3 translation(random.cube(100.0f));
    const double s = std::sin(angle / 2) * random.uniform(0.99f, 1.0f) / length(DVec3(axis));
    trs.rotation = {axis.x * s, axis.y * s, axis.z * s, std::cos(angle / 2)};
    trs.scale = {scale.x, scale.y, scale.z};
    trs.translation = {translation.x, translation.y, translation.z};
    const double norm =
        std::sqrt(s * s * dot(DVec3(axis), DVec3(axis)) + trs.rotation[3] * trs.rotation[3]);
    // The rotation by Rodrigues' formula, v' = v cos + (k x v) sin + k (k . v)(1 - cos).
    const double half = std::acos(trs.rotation[3] / norm) * (angle < 0 ? -1.0 : 1.0);
    const DVec3 k = normalize(DVec3(axis));
    const DMat4 matrix = gltf::local_matrix(trs);
    const DVec3 point(random.cube(5.0f));
    const DVec3 v = point * scale;
    const DVec3 turned = v * std::cos(2 * half) + cross(k, v) * std::sin(2 * half) +
                         k * dot(k, v) * (1 - std::cos(2 * half));
    expect_near(DVec3(matrix * glm::dvec4(point, 1.0)), turned + translation, 1e-9);

    tinygltf::Node same;
    for (int e = 0; e < 16; ++e) same.matrix.push_back(matrix[e / 4][e % 4]);
    ASSERT_EQ(gltf::local_matrix(same), matrix);
  }
}

TEST(GltfNode, Parents_MultiplyFromTheLeft) {
  GltfFile file = test::triangle_file();
  file.json["nodes"] = nlohmann::json::parse(R"([
    {"children": [1], "scale": [2, 2, 2]}, {"mesh": 0, "translation": [1, 0, 0]}])");
  file.json["scenes"] = {{{"nodes", {0}}}};
  expect_near(corner(load(file)), {4, 0, 0}, 0);
}

TEST(GltfNode, FlatMatrix_IsNotedNotDrawn) {
  for (const nlohmann::json& scale : {nlohmann::json{1, 0, 1}, nlohmann::json{1e300, 1e300, 1}}) {
    const LoadedScene loaded = load(with_node({{"mesh", 0}, {"scale", scale}}));
    EXPECT_TRUE(loaded.scene.world.instances.empty());
    EXPECT_THAT(loaded.notes, ElementsAre(HasSubstr("node 0: its matrix")));
  }
}

TEST(GltfNode, ChainOfManyNodes_DoesNotOverflow) {
  constexpr int k_nodes = 100'000;
  GltfFile file = test::triangle_file();
  nlohmann::json nodes;
  for (int i = 0; i + 1 < k_nodes; ++i) {
    nodes.push_back({{"children", {i + 1}}, {"translation", {0.001, 0, 0}}});
  }
  nodes.push_back({{"mesh", 0}});
  file.json["nodes"] = std::move(nodes);
  file.json["scenes"] = {{{"nodes", {0}}}};
  expect_near(corner(load(file)), {1 + 0.001 * (k_nodes - 1), 0, 0}, 1e-8);
}

TEST(GltfScene, WithoutScenes_AllRootsAreDrawn) {
  GltfFile file = test::triangle_file();
  file.json.erase("scenes");
  file.json.erase("scene");
  const LoadedScene loaded = load(file);
  EXPECT_EQ(loaded.scene.world.instances.size(), 1u);
  EXPECT_EQ(loaded.scene.cameras.size(), 1u);
  EXPECT_TRUE(loaded.scene_names.empty());
  EXPECT_THROW(load(file, {.scene = "0"}), Error);
}

TEST(GltfScene, IsChosenByNameOrNumber) {
  GltfFile file = test::triangle_file();
  file.json["scenes"] = nlohmann::json::parse(
      R"([{"nodes": [0]}, {"name": "garden", "nodes": [2]}, {"name": "0", "nodes": []}])");
  file.json["scene"] = 1;
  EXPECT_EQ(load(file).scene_index, 1u);
  EXPECT_THAT(load(file).scene_names, ElementsAre("scene 0", "garden", "0"));
  EXPECT_EQ(load(file, {.scene = "garden"}).scene_index, 1u);
  EXPECT_EQ(load(file, {.scene = "1"}).scene_index, 1u);
  EXPECT_EQ(load(file, {.scene = "0"}).scene_index, 2u);  // a name comes before a number
  EXPECT_EQ(load(file, {.scene = "scene 0"}).scene.world.instances.size(), 1u);
  EXPECT_THAT([&] { load(file, {.scene = "gardn"}); },
              testing::ThrowsMessage<Error>(HasSubstr("did you mean garden?")));
  EXPECT_THROW(load(file, {.scene = "3"}), Error);
}

TEST(GltfCamera, PerspectiveAtNode_HasOrthonormalFrame) {
  GltfFile file = with_node({{"camera", 0},
                             {"name", "eye"},
                             {"matrix", {0, 0, -2, 0, 0, 3, 0, 0, 5, 0, 0, 0, 7, 8, 9, 1}}});
  file.json["cameras"][0]["perspective"] = {{"yfov", 0.5}, {"aspectRatio", 2}, {"znear", 1}};
  const geometry::Camera camera = load(file).scene.cameras.at(0);
  EXPECT_EQ(camera.name, "eye");
  EXPECT_EQ(camera.projection, geometry::Camera::Projection::perspective);
  EXPECT_FLOAT_EQ(camera.vertical_fov, 0.5f);
  EXPECT_FLOAT_EQ(camera.aspect, 2.0f);
  EXPECT_EQ(camera.position, Vec3(7, 8, 9));
  EXPECT_EQ(camera.right, Vec3(0, 0, -1));
  EXPECT_EQ(camera.up, Vec3(0, 1, 0));
  EXPECT_EQ(camera.backward, Vec3(1, 0, 0));
}

TEST(GltfCamera, Orthographic_TakesItsMagnification) {
  GltfFile file = with_node({{"camera", 0}, {"scale", {-1, 1, 1}}});
  file.json["cameras"][0] = nlohmann::json::parse(R"({"name": "plan", "type": "orthographic",
      "orthographic": {"xmag": 6, "ymag": 3, "znear": 0, "zfar": 10}})");
  const geometry::Camera camera = load(file).scene.cameras.at(0);
  EXPECT_EQ(camera.name, "plan");
  EXPECT_EQ(camera.projection, geometry::Camera::Projection::orthographic);
  EXPECT_FLOAT_EQ(camera.half_height, 3.0f);
  EXPECT_FLOAT_EQ(camera.aspect, 2.0f);
  EXPECT_EQ(camera.right, Vec3(1, 0, 0));  // a mirrored node does not mirror the picture
}

TEST(GltfCamera, EveryNodeWithACamera_GivesOneDepthFirst) {
  GltfFile file = test::triangle_file();
  file.json["nodes"] = nlohmann::json::parse(R"([
    {"camera": 0, "children": [2, 1]}, {"camera": 0, "name": "b"}, {"camera": 0, "name": "a"}])");
  file.json["scenes"] = {{{"nodes", {0}}}};
  const LoadedScene loaded = load(file);
  ASSERT_EQ(loaded.scene.cameras.size(), 3u);
  EXPECT_EQ(loaded.scene.cameras[0].name, "camera 0");
  EXPECT_EQ(loaded.scene.cameras[1].name, "a");
  EXPECT_EQ(loaded.scene.cameras[2].name, "b");
}

TEST(GltfLight, Spot_ShinesAlongMinusZOfItsNode) {
  const double s = std::sqrt(0.5);  // a quarter turn around y: -z becomes -x
  GltfFile file = with_node({{"translation", {1, 2, 3}},
                             {"rotation", {0, s, 0, s}},
                             {"scale", {4, 4, 4}},
                             {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  file.json["extensions"]["KHR_lights_punctual"]["lights"][0] = nlohmann::json::parse(
      R"({"type": "spot", "name": "lamp", "color": [1, 0.5, 0], "intensity": 40, "range": 12,
          "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.3}})");
  const shading::PunctualLight light = load(file).scene.lights.at(0);
  EXPECT_EQ(light.name, "lamp");
  EXPECT_EQ(light.kind, shading::PunctualLight::Kind::spot);
  EXPECT_EQ(light.intensity, Vec3(40, 20, 0));
  EXPECT_EQ(light.position, Vec3(1, 2, 3));
  EXPECT_LE(length(light.direction - Vec3(-1, 0, 0)), 1e-6f);
  EXPECT_FLOAT_EQ(light.range, 12.0f);
  EXPECT_FLOAT_EQ(light.inner_cone, 0.1f);
  EXPECT_FLOAT_EQ(light.outer_cone, 0.3f);
}

TEST(GltfLight, Defaults_AreThoseOfTheExtension) {
  const shading::PunctualLight light = load(test::triangle_file()).scene.lights.at(0);
  EXPECT_EQ(light.kind, shading::PunctualLight::Kind::point);
  EXPECT_EQ(light.intensity, Vec3(1));
  EXPECT_TRUE(std::isinf(light.range));
}

TEST(GltfOrigin, SceneNearZero_StaysPut) {
  const LoadedScene loaded = load(with_node({{"mesh", 0}, {"translation", {2, 0, 0}}}));
  EXPECT_EQ(loaded.scene.origin, DVec3(0));
  EXPECT_EQ(corner(loaded), DVec3(3, 0, 0));
}

TEST(GltfOrigin, SceneFarAway_IsMovedInDouble) {
  GltfFile file = test::triangle_file();
  file.json["nodes"] = nlohmann::json::parse(R"([
    {"mesh": 0, "translation": [1000000.0625, -2000000, 0.3]},
    {"camera": 0, "translation": [1000000.001, -2000000, 5]},
    {"translation": [1000000.002, -2000000, 5],
     "extensions": {"KHR_lights_punctual": {"light": 0}}}])");
  file.json["scenes"] = {{{"nodes", {0, 1, 2}}}};
  const LoadedScene loaded = load(file);
  expect_near(corner(loaded), {1000001.0625, -2000000, 0.3}, 1e-9);
  EXPECT_LT(length(loaded.scene.world.instances[0].transform.translation()), 2.0);
  // A float has steps of 6 cm out there; a millimetre must survive.
  const Vec3 apart = loaded.scene.lights[0].position - loaded.scene.cameras[0].position;
  EXPECT_NEAR(apart.x, 0.001f, 1e-6f);
  expect_near(loaded.scene.origin + DVec3(loaded.scene.cameras[0].position),
              {1000000.001, -2000000, 5}, 1e-6);
}

TEST(GltfOrigin, MeshFarFromItsOwnOrigin_KeepsItsPositionsExactly) {
  const std::vector<float> positions = {1e6f, 0.1f, -3, 1e6f + 1.5f, 0.3f, -3, 1e6f, 1, -3.25f};
  GltfFile file;
  file.add_floats(positions, "VEC3", 3);
  file.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}});
  file.add("nodes", {{"mesh", 0}, {"translation", {-1e6, 0, 0}}});
  const LoadedScene loaded = load(file);
  EXPECT_EQ(loaded.scene.origin, DVec3(0));
  const geometry::Transform& transform = loaded.scene.world.instances[0].transform;
  const geometry::Mesh& mesh = *loaded.scene.world.objects[0].geometries[0].mesh();
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(std::abs(mesh.positions[i].x), 2.0f);
    const DVec3 world = transform.point_to_world(DVec3(mesh.positions[i]));
    EXPECT_EQ(world,
              DVec3(double{positions[3 * i]} - 1e6, positions[3 * i + 1], positions[3 * i + 2]));
  }
}

TEST(GltfOrigin, MeshBeyondAllBounds_IsNotedNotDrawn) {
  const LoadedScene loaded = load(with_node({{"mesh", 0}, {"translation", {1e18, 0, 0}}}));
  EXPECT_TRUE(loaded.scene.world.instances.empty());
  EXPECT_THAT(loaded.notes, ElementsAre(HasSubstr("beyond")));
}

}  // namespace
}  // namespace lume::io
