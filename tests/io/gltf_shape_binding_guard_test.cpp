// SPDX-License-Identifier: Apache-2.0
// What a file says of the nodes and primitives that are bound to analytic shapes.
#include "tests/io/gltf_guard.h"

namespace lume::io {
namespace {

/// Changes to a file with a sphere on a node and, in place of its triangle, on a primitive.
class GltfShapeBindingGuard : public testing::TestWithParam<test::GuardCase> {};

nlohmann::json bound_file() {
  nlohmann::json json = test::triangle_file().complete();
  json["extensions"]["KHR_implicit_shapes"]["shapes"] = {{{"type", "sphere"}}};
  json["nodes"][0]["extensions"]["LUME_shape"] = {{"shape", 0}, {"material", 0}};
  json["meshes"][0]["primitives"][0]["extensions"]["LUME_shape"] = {{"shape", 0}};
  return json;
}

TEST_P(GltfShapeBindingGuard, BadBinding_IsSceneErrorWithPointer) {
  test::expect_scene_error(bound_file().patch(nlohmann::json::parse(GetParam().patch)),
                           GetParam().pointer);
}

constexpr test::GuardCase k_binding_cases[] = {
    {"ShapesNotArray",
     R"([{"op":"replace","path":"/extensions/KHR_implicit_shapes/shapes","value":{}}])",
     "/extensions/KHR_implicit_shapes/shapes"},
    {"NoShapes", R"([{"op":"remove","path":"/extensions/KHR_implicit_shapes/shapes"}])",
     "/extensions/KHR_implicit_shapes"},
    {"NoExtension", R"([{"op":"remove","path":"/extensions/KHR_implicit_shapes"}])",
     "/meshes/0/primitives/0/extensions/LUME_shape/shape"},
    {"NodeNoSuchShape",
     R"([{"op":"replace","path":"/nodes/0/extensions/LUME_shape/shape","value":1}])",
     "/nodes/0/extensions/LUME_shape/shape"},
    {"NodeShapeNegative",
     R"([{"op":"replace","path":"/nodes/0/extensions/LUME_shape/shape","value":-1}])",
     "/nodes/0/extensions/LUME_shape/shape"},
    {"NodeWithoutShape", R"([{"op":"remove","path":"/nodes/0/extensions/LUME_shape/shape"}])",
     "/nodes/0/extensions/LUME_shape"},
    {"NodeNoSuchMaterial",
     R"([{"op":"replace","path":"/nodes/0/extensions/LUME_shape/material","value":1}])",
     "/nodes/0/extensions/LUME_shape/material"},
    {"NodeNotObject", R"([{"op":"replace","path":"/nodes/0/extensions/LUME_shape","value":0}])",
     "/nodes/0/extensions/LUME_shape"},
    {"PrimitiveNoSuchShape",
     R"([{"op":"replace","path":"/meshes/0/primitives/0/extensions/LUME_shape/shape","value":7}])",
     "/meshes/0/primitives/0/extensions/LUME_shape/shape"},
    {"PrimitiveShapeText",
     R"([{"op":"replace","path":"/meshes/0/primitives/0/extensions/LUME_shape/shape",
          "value":"0"}])",
     "/meshes/0/primitives/0/extensions/LUME_shape/shape"},
};
INSTANTIATE_TEST_SUITE_P(Binding, GltfShapeBindingGuard, testing::ValuesIn(k_binding_cases),
                         test::case_name);

}  // namespace
}  // namespace lume::io
