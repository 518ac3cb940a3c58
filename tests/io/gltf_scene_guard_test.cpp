// SPDX-License-Identifier: Apache-2.0
// What a file says of its nodes, cameras and lights.
#include "tests/io/gltf_guard.h"

namespace lume::io {
namespace {

using Case = test::GuardCase;

class GltfSceneGuard : public testing::TestWithParam<Case> {};

TEST_P(GltfSceneGuard, BrokenFile_IsSceneErrorWithPointer) { test::expect_scene_error(GetParam()); }

constexpr Case k_node_cases[] = {
    {"NoSuchMesh", R"([{"op":"replace","path":"/nodes/0/mesh","value":1}])", "/nodes/0/mesh"},
    {"MeshNegative", R"([{"op":"replace","path":"/nodes/0/mesh","value":-2}])", "/nodes/0/mesh"},
    {"NoSuchCamera", R"([{"op":"replace","path":"/nodes/1/camera","value":1}])", "/nodes/1/camera"},
    {"NoSuchSkin", R"([{"op":"add","path":"/nodes/0/skin","value":0}])", "/nodes/0/skin"},
    {"NoSuchLight",
     R"([{"op":"replace","path":"/nodes/2/extensions/KHR_lights_punctual/light","value":1}])",
     "/nodes/2/extensions/KHR_lights_punctual/light"},
    {"ExtensionNotObject",
     R"([{"op":"replace","path":"/nodes/2/extensions/KHR_lights_punctual","value":1}])",
     "/nodes/2/extensions/KHR_lights_punctual"},
    {"NoSuchChild", R"([{"op":"replace","path":"/nodes/0/children","value":[3]}])",
     "/nodes/0/children/0"},
    {"OwnChild", R"([{"op":"add","path":"/nodes/1/children","value":[1]},
         {"op":"remove","path":"/nodes/0/children"}])",
     "/nodes/1"},
    {"CycleOfTwo",
     R"([{"op":"add","path":"/nodes/1/children","value":[0]},
         {"op":"replace","path":"/scenes/0/nodes","value":[2]}])",
     "/nodes/0"},
    {"TwoParents", R"([{"op":"add","path":"/nodes/2/children","value":[1]}])",
     "/nodes/2/children/0"},
    {"ChildTwice", R"([{"op":"replace","path":"/nodes/0/children","value":[1,1]}])",
     "/nodes/0/children/1"},
    {"MatrixShort", R"([{"op":"add","path":"/nodes/0/matrix","value":[1,0,0]}])",
     "/nodes/0/matrix"},
    {"MatrixProjective",
     R"([{"op":"add","path":"/nodes/0/matrix","value":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]}])",
     "/nodes/0/matrix"},
    {"RotationZero", R"([{"op":"add","path":"/nodes/0/rotation","value":[0,0,0,0]}])",
     "/nodes/0/rotation"},
    {"TranslationText", R"([{"op":"add","path":"/nodes/0/translation","value":[0,"1",0]}])",
     "/nodes/0/translation/1"},
    {"NoSuchSceneNode", R"([{"op":"replace","path":"/scenes/0/nodes/0","value":3}])",
     "/scenes/0/nodes/0"},
    {"SceneNodeTwice", R"([{"op":"replace","path":"/scenes/0/nodes","value":[2,2]}])",
     "/scenes/0/nodes/1"},
    {"SceneNodeIsChild", R"([{"op":"replace","path":"/scenes/0/nodes/0","value":1}])",
     "/scenes/0/nodes/0"},
    {"NoSuchScene", R"([{"op":"replace","path":"/scene","value":1}])", "/scene"},
    {"NodesNotArray", R"([{"op":"replace","path":"/nodes","value":{}}])", "/nodes"},
};

constexpr Case k_camera_and_light_cases[] = {
    {"CameraType", R"([{"op":"replace","path":"/cameras/0/type","value":"fisheye"}])",
     "/cameras/0/type"},
    {"CameraOfBothTypes",
     R"([{"op":"add","path":"/cameras/0/orthographic","value":{"xmag":1,"ymag":1}}])",
     "/cameras/0"},
    {"NearPlaneZero", R"([{"op":"replace","path":"/cameras/0/perspective/znear","value":0}])",
     "/cameras/0/perspective/znear"},
    {"FarPlaneBeforeNear", R"([{"op":"add","path":"/cameras/0/perspective/zfar","value":0.1}])",
     "/cameras/0/perspective/zfar"},
    {"NoPerspective", R"([{"op":"remove","path":"/cameras/0/perspective"}])", "/cameras/0"},
    {"FieldOfViewZero", R"([{"op":"replace","path":"/cameras/0/perspective/yfov","value":0}])",
     "/cameras/0/perspective/yfov"},
    {"FieldOfViewTooWide", R"([{"op":"replace","path":"/cameras/0/perspective/yfov","value":3.2}])",
     "/cameras/0/perspective/yfov"},
    {"MagnificationZero",
     R"([{"op":"replace","path":"/cameras/0","value":{"type":"orthographic",
          "orthographic":{"xmag":1,"ymag":0,"znear":0,"zfar":1}}}])",
     "/cameras/0/orthographic/ymag"},
    {"LightType",
     R"([{"op":"replace","path":"/extensions/KHR_lights_punctual/lights/0/type","value":"area"}])",
     "/extensions/KHR_lights_punctual/lights/0/type"},
    {"LightTypeNumber",
     R"([{"op":"replace","path":"/extensions/KHR_lights_punctual/lights/0/type","value":1}])",
     "/extensions/KHR_lights_punctual/lights/0/type"},
    {"LightColor",
     R"([{"op":"add","path":"/extensions/KHR_lights_punctual/lights/0/color","value":"red"}])",
     "/extensions/KHR_lights_punctual/lights/0/color"},
    {"LightRangeZero",
     R"([{"op":"add","path":"/extensions/KHR_lights_punctual/lights/0/range","value":0}])",
     "/extensions/KHR_lights_punctual/lights/0/range"},
    {"LightIntensityNegative",
     R"([{"op":"add","path":"/extensions/KHR_lights_punctual/lights/0/intensity","value":-5}])",
     "/extensions/KHR_lights_punctual/lights/0/intensity"},
    {"SpotWithoutCone",
     R"([{"op":"replace","path":"/extensions/KHR_lights_punctual/lights/0/type",
          "value":"spot"}])",
     "/extensions/KHR_lights_punctual/lights/0"},
    {"ConesSwapped",
     R"([{"op":"replace","path":"/extensions/KHR_lights_punctual/lights/0",
          "value":{"type":"spot","spot":{"innerConeAngle":0.6,"outerConeAngle":0.5}}}])",
     "/extensions/KHR_lights_punctual/lights/0/spot"},
    {"ConeTooWide",
     R"([{"op":"replace","path":"/extensions/KHR_lights_punctual/lights/0",
          "value":{"type":"spot","spot":{"outerConeAngle":2}}}])",
     "/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle"},
    {"LightsNotArray",
     R"([{"op":"replace","path":"/extensions/KHR_lights_punctual/lights","value":{}}])",
     "/extensions/KHR_lights_punctual/lights"},
};

INSTANTIATE_TEST_SUITE_P(Node, GltfSceneGuard, testing::ValuesIn(k_node_cases), test::case_name);
INSTANTIATE_TEST_SUITE_P(CameraAndLight, GltfSceneGuard,
                         testing::ValuesIn(k_camera_and_light_cases), test::case_name);

TEST(GltfSceneGuardBase, UnbrokenFile_Loads) {
  const tests::TemporaryFolder folder;
  const LoadedScene loaded = load_gltf(test::triangle_file().write(folder / "good.gltf"));
  EXPECT_EQ(loaded.scene.world.instances.size(), 1u);
  EXPECT_EQ(loaded.scene.cameras.size(), 1u);
  EXPECT_EQ(loaded.scene.lights.size(), 1u);
  EXPECT_TRUE(loaded.notes.empty());
}

}  // namespace
}  // namespace lume::io
