// SPDX-License-Identifier: Apache-2.0
// Where analytic shapes are drawn, and with which materials.
#include "io/error.h"
#include "tests/io/gltf_shape_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace lume::io {
namespace {

using geometry::DVec3;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const geometry::Geometry& first_geometry(const LoadedScene& loaded) {
  return loaded.scene.world.objects.at(0).geometries.at(0);
}

TEST(GltfShapeBinding, NodesOfOneShapeAndMaterial_ShareAnObject) {
  const nlohmann::json shapes = {{{"type", "sphere"}, {"name", "ball"}}, {{"type", "box"}}};
  nlohmann::json nodes;
  for (const std::size_t shape : {0, 1, 0, 0}) nodes.push_back(test::shape_node(shape));
  nodes[3]["extensions"]["LUME_shape"]["material"] = 0;
  nodes[2]["name"] = "second";
  nodes[2]["translation"] = {1, 2, 3};
  nlohmann::json json = test::shapes_file(shapes, nodes);
  json["materials"] = {{{"name", "paint"}}};
  const LoadedScene loaded = test::load_json(json);
  const geometry::World& world = loaded.scene.world;
  ASSERT_EQ(world.objects.size(), 3u);
  ASSERT_EQ(world.instances.size(), 4u);
  EXPECT_EQ(world.objects[0].name, "ball");
  EXPECT_EQ(world.objects[1].name, "shape 1");
  EXPECT_EQ(world.instances[2].object, world.instances[0].object);
  EXPECT_EQ(world.instances[2].name, "second");
  EXPECT_EQ(world.instances[2].transform.translation(), DVec3(1, 2, 3));
  EXPECT_EQ(world.objects[world.instances[3].object].geometries[0].material, 0u);
  ASSERT_EQ(loaded.scene.materials.size(), 2u);
  EXPECT_EQ(loaded.scene.materials[world.objects[0].geometries[0].material].name, "default");
}

/// The triangle file with its primitive bound to a sphere.
nlohmann::json bound_primitive() {
  nlohmann::json json = test::triangle_file().complete();
  json["extensions"]["KHR_implicit_shapes"]["shapes"] = {{{"type", "sphere"}}};
  json["meshes"][0]["primitives"][0]["extensions"]["LUME_shape"] = {{"shape", 0}};
  return json;
}

TEST(GltfShapeBinding, NodeWithMeshAndShape_ShowsBoth) {
  nlohmann::json json = bound_primitive();
  json["meshes"][0]["primitives"][0].erase("extensions");
  json["nodes"][0]["extensions"]["LUME_shape"] = {{"shape", 0}};
  const LoadedScene loaded = test::load_json(json);
  ASSERT_EQ(loaded.scene.world.instances.size(), 2u);
  EXPECT_NE(loaded.scene.world.objects[0].geometries.at(0).mesh(), nullptr);
  EXPECT_NE(loaded.scene.world.objects[1].geometries.at(0).shape(), nullptr);
}

TEST(GltfShapeBinding, Primitive_KeepsItsMaterialAndLosesItsTriangles) {
  nlohmann::json json = bound_primitive();
  json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}});
  const LoadedScene loaded = test::load_json(json);
  const auto& geometries = loaded.scene.world.objects.at(0).geometries;
  ASSERT_EQ(geometries.size(), 2u);
  EXPECT_NE(geometries[0].shape(), nullptr);
  EXPECT_EQ(geometries[0].material, 0u);
  EXPECT_NE(geometries[1].mesh(), nullptr);
}

TEST(GltfShapeBinding, FallbackTriangles_AreNotEvenRead) {
  test::GltfFile file = test::triangle_file();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  file.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] =
      file.add_floats({nan, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3);
  nlohmann::json json = file.complete();
  EXPECT_THROW(test::load_json(json), Error);
  json["extensions"]["KHR_implicit_shapes"]["shapes"] = {{{"type", "sphere"}}};
  json["meshes"][0]["primitives"][0]["extensions"]["LUME_shape"] = {{"shape", 0}};
  EXPECT_NO_THROW(test::load_json(json));
  EXPECT_THROW(test::load_json(json, test::tessellated()), Error);
  json["meshes"][0]["primitives"][0]["attributes"].clear();
  EXPECT_EQ(test::load_json(json).scene.world.instances.size(), 1u);
}

TEST(GltfShapeBinding, Tessellated_DrawsTrianglesAndNotesTheRest) {
  nlohmann::json json = bound_primitive();
  json["nodes"][0]["extensions"]["LUME_shape"] = {{"shape", 0}};
  const LoadedScene loaded = test::load_json(json, test::tessellated());
  ASSERT_EQ(loaded.scene.world.objects.size(), 1u);
  EXPECT_NE(first_geometry(loaded).mesh(), nullptr);
  EXPECT_THAT(loaded.notes, ElementsAre(HasSubstr("node 0: its shape has no triangles")));
}

TEST(GltfShapeBinding, DoubleSidedPlane_GetsOneCopyOfItsMaterial) {
  const nlohmann::json shapes = {test::shape_of("plane", {{"doubleSided", true}}),
                                 test::shape_of("plane", {{"doubleSided", true}, {"sizeX", 1}}),
                                 {{"type", "plane"}}};
  nlohmann::json nodes;
  for (const std::size_t shape : {0, 1, 2, 0}) {
    nodes.push_back(test::shape_node(shape));
    nodes.back()["extensions"]["LUME_shape"]["material"] = 0;
  }
  nodes[3]["extensions"]["LUME_shape"]["material"] = 1;
  nlohmann::json json = test::shapes_file(shapes, nodes);
  json["materials"] = {{{"name", "a"}}, {{"name", "b"}, {"doubleSided", true}}};
  const LoadedScene loaded = test::load_json(json);
  const auto material = [&](std::size_t object) {
    return loaded.scene.world.objects[object].geometries[0].material;
  };
  ASSERT_EQ(loaded.scene.materials.size(), 3u);
  EXPECT_EQ(material(0), 2u);
  EXPECT_EQ(material(1), 2u);
  EXPECT_EQ(material(2), 0u);
  EXPECT_EQ(material(3), 1u);  // shows both sides already
  EXPECT_TRUE(loaded.scene.materials[2].double_sided);
  EXPECT_FALSE(loaded.scene.materials[0].double_sided);
}

TEST(GltfShapeBinding, DefaultAndDoubleSidedMaterials_DoNotMixUp) {
  const nlohmann::json shapes = {test::shape_of("plane", {{"doubleSided", true}}),
                                 {{"type", "sphere"}}};
  const LoadedScene loaded = test::load_json(
      test::shapes_file(shapes, nlohmann::json::array({test::shape_node(0), test::shape_node(1)})));
  const auto& materials = loaded.scene.materials;
  const auto& objects = loaded.scene.world.objects;
  EXPECT_TRUE(materials.at(objects.at(0).geometries[0].material).double_sided);
  EXPECT_FALSE(materials.at(objects.at(1).geometries[0].material).double_sided);
  EXPECT_EQ(materials.at(objects.at(1).geometries[0].material).name, "default");
}

TEST(GltfShapeBinding, MaskedMaterial_MakesHoles) {
  nlohmann::json json = bound_primitive();
  EXPECT_FALSE(first_geometry(test::load_json(json)).has_holes);
  json["materials"][0]["alphaMode"] = "MASK";
  EXPECT_TRUE(first_geometry(test::load_json(json)).has_holes);  // textured
  json["materials"][0].erase("pbrMetallicRoughness");
  EXPECT_FALSE(first_geometry(test::load_json(json)).has_holes);
  json["materials"][0]["pbrMetallicRoughness"] = {{"baseColorFactor", {1, 1, 1, 0.25}}};
  EXPECT_TRUE(first_geometry(test::load_json(json)).has_holes);
}

TEST(GltfShapeBinding, FlatMatrix_IsNotedNotDrawn) {
  nlohmann::json json = test::shape_file({{"type", "sphere"}});
  json["nodes"][0]["scale"] = {1, 0, 1};
  const LoadedScene loaded = test::load_json(json);
  EXPECT_THAT(loaded.scene.world.instances, IsEmpty());
  EXPECT_THAT(loaded.notes, ElementsAre(HasSubstr("node 0: its matrix")));
}

TEST(GltfShapeOrigin, EndlessPlane_DoesNotMoveTheScene) {
  const nlohmann::json shapes = {{{"type", "plane"}}, {{"type", "sphere"}}};
  nlohmann::json nodes = {test::shape_node(0), test::shape_node(1)};
  nodes[0]["translation"] = {0, -3e6, 0};
  const LoadedScene near = test::load_json(test::shapes_file(shapes, nodes));
  EXPECT_EQ(near.scene.origin, DVec3(0));
  EXPECT_EQ(near.scene.world.instances.at(0).transform.translation(), DVec3(0, -3e6, 0));
  EXPECT_TRUE(near.scene.world.bounds().is_finite());

  nodes[1]["translation"] = {2e6, 0, 0};  // the sphere is the scene; the plane moves with it
  const LoadedScene far = test::load_json(test::shapes_file(shapes, nodes));
  EXPECT_EQ(far.scene.origin, DVec3(2e6, 0, 0));
  EXPECT_EQ(far.scene.world.instances.at(0).transform.translation(), DVec3(-2e6, -3e6, 0));
  EXPECT_EQ(far.scene.world.instances.at(1).transform.translation(), DVec3(0));
}

TEST(GltfShapeOrigin, OnlyEndlessSurfaces_HaveNoBounds) {
  const LoadedScene loaded = test::load_json(test::shape_file({{"type", "plane"}}));
  EXPECT_EQ(loaded.scene.world.instances.size(), 1u);
  EXPECT_TRUE(loaded.scene.world.bounds().is_empty());
  EXPECT_EQ(loaded.scene.origin, DVec3(0));
}

TEST(GltfShapeOrigin, BeyondAllBounds_IsNotedNotDrawn) {
  for (const char* type : {"plane", "sphere"}) {
    nlohmann::json json = test::shape_file({{"type", type}});
    json["nodes"][0]["translation"] = {0, 1e16, 0};
    const LoadedScene loaded = test::load_json(json);
    EXPECT_THAT(loaded.scene.world.instances, IsEmpty());
    EXPECT_THAT(loaded.notes, ElementsAre(HasSubstr("beyond")));
  }
}

}  // namespace
}  // namespace lume::io
