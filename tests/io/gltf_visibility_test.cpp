// SPDX-License-Identifier: Apache-2.0
// KHR_node_visibility.
#include "tests/io/gltf_guard.h"

#include <gtest/gtest.h>

namespace lume::io {
namespace {

/// The triangle file, in which node 0 has a mesh, its child 1 a camera, and node 2 a light.
shading::Scene load_with(std::size_t node, const nlohmann::json& extension) {
  nlohmann::json json = test::triangle_file().complete();
  json["extensionsUsed"].push_back("KHR_node_visibility");
  json["extensionsRequired"] = {"KHR_node_visibility"};
  json["nodes"][node]["extensions"]["KHR_node_visibility"] = extension;
  const tests::TemporaryFolder folder;
  test::write_bytes(folder / "scene.gltf", json.dump());
  return load_gltf(folder / "scene.gltf").scene;
}

const nlohmann::json k_hidden = {{"visible", false}};

TEST(GltfVisibility, HiddenNode_TakesItsDescendantsAlong) {
  const shading::Scene scene = load_with(0, k_hidden);
  EXPECT_EQ(scene.world.instances.size(), 0u);
  EXPECT_EQ(scene.cameras.size(), 0u);
  EXPECT_EQ(scene.lights.size(), 1u);
}

TEST(GltfVisibility, HiddenCamera_LeavesItsParent) {
  const shading::Scene scene = load_with(1, k_hidden);
  EXPECT_EQ(scene.world.instances.size(), 1u);
  EXPECT_EQ(scene.cameras.size(), 0u);
  EXPECT_EQ(scene.lights.size(), 1u);
}

TEST(GltfVisibility, HiddenLight_IsOut) {
  const shading::Scene scene = load_with(2, k_hidden);
  EXPECT_EQ(scene.world.instances.size(), 1u);
  EXPECT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.lights.size(), 0u);
}

TEST(GltfVisibility, VisibleOrNotSaid_IsShown) {
  for (const nlohmann::json& extension :
       {nlohmann::json{{"visible", true}}, nlohmann::json::object()}) {
    const shading::Scene scene = load_with(0, extension);
    EXPECT_EQ(scene.world.instances.size(), 1u);
    EXPECT_EQ(scene.cameras.size(), 1u);
  }
}

TEST(GltfVisibility, NotABoolean_IsAnError) {
  nlohmann::json json = test::triangle_file().complete();
  json["nodes"][1]["extensions"]["KHR_node_visibility"]["visible"] = 0;
  test::expect_scene_error(json, "/nodes/1/extensions/KHR_node_visibility/visible");
}

}  // namespace
}  // namespace lume::io
