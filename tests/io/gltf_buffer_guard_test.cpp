// SPDX-License-Identifier: Apache-2.0
// What a file says of itself, its buffers and its meshes.
#include "tests/io/gltf_guard.h"

namespace lume::io {
namespace {

using Case = test::GuardCase;

class GltfBufferGuard : public testing::TestWithParam<Case> {};

TEST_P(GltfBufferGuard, BrokenFile_IsSceneErrorWithPointer) {
  test::expect_scene_error(GetParam());
}

constexpr Case k_asset_cases[] = {
    {"NoAsset", R"([{"op":"remove","path":"/asset"}])", ""},
    {"NoVersion", R"([{"op":"remove","path":"/asset/version"}])", "/asset"},
    {"VersionNine", R"([{"op":"replace","path":"/asset/version","value":"9.9"}])",
     "/asset/version"},
    {"VersionOne", R"([{"op":"replace","path":"/asset/version","value":"1.0"}])", "/asset/version"},
    {"VersionText", R"([{"op":"replace","path":"/asset/version","value":"two"}])",
     "/asset/version"},
    {"VersionNumber", R"([{"op":"replace","path":"/asset/version","value":2.5}])",
     "/asset/version"},
    {"MinVersion", R"([{"op":"add","path":"/asset/minVersion","value":"2.1"}])",
     "/asset/minVersion"},
    {"RequiredUnknown", R"([{"op":"add","path":"/extensionsRequired","value":["ACME_magic"]}])",
     "/extensionsRequired/0"},
    {"UsedNotArray", R"([{"op":"replace","path":"/extensionsUsed","value":"x"}])",
     "/extensionsUsed"},
    {"UsedNumbers", R"([{"op":"replace","path":"/extensionsUsed","value":[3]}])",
     "/extensionsUsed/0"},
};

constexpr Case k_buffer_cases[] = {
    {"BufferLengthLie", R"([{"op":"replace","path":"/buffers/0/byteLength","value":4000000000}])",
     "/buffers/0/byteLength"},
    {"BufferLengthHuge",
     R"([{"op":"replace","path":"/buffers/0/byteLength","value":9223372036854775807}])",
     "/buffers/0/byteLength"},
    {"BufferLengthNegative", R"([{"op":"replace","path":"/buffers/0/byteLength","value":-1}])",
     "/buffers/0/byteLength"},
    {"BufferNoUri", R"([{"op":"remove","path":"/buffers/0/uri"}])", "/buffers/0"},
    {"BufferUriNumber", R"([{"op":"replace","path":"/buffers/0/uri","value":7}])",
     "/buffers/0/uri"},
    {"BufferMissing", R"([{"op":"replace","path":"/buffers/0/uri","value":"none.bin"}])",
     "/buffers/0/uri"},
    {"BufferBadBase64", R"([{"op":"replace","path":"/buffers/0/uri","value":"data:;base64,AA*A"}])",
     "/buffers/0/uri"},
    {"BufferNotObject", R"([{"op":"replace","path":"/buffers/0","value":5}])", "/buffers/0"},
    {"ViewBeyondBuffer", R"([{"op":"replace","path":"/bufferViews/2/byteLength","value":2400}])",
     "/bufferViews/2"},
    {"ViewOffsetWraps",
     R"([{"op":"replace","path":"/bufferViews/2/byteOffset","value":18446744073709551615}])",
     "/bufferViews/2"},
    {"ViewOffsetNegative", R"([{"op":"replace","path":"/bufferViews/0/byteOffset","value":-4}])",
     "/bufferViews/0/byteOffset"},
    {"ViewNoSuchBuffer", R"([{"op":"replace","path":"/bufferViews/0/buffer","value":1}])",
     "/bufferViews/0/buffer"},
    {"ViewStrideThree", R"([{"op":"add","path":"/bufferViews/0/byteStride","value":3}])",
     "/bufferViews/0/byteStride"},
    {"ViewStrideHuge", R"([{"op":"add","path":"/bufferViews/0/byteStride","value":256}])",
     "/bufferViews/0/byteStride"},
};

constexpr Case k_accessor_cases[] = {
    {"NoSuchView", R"([{"op":"replace","path":"/accessors/0/bufferView","value":3}])",
     "/accessors/0/bufferView"},
    {"CountLie", R"([{"op":"replace","path":"/accessors/0/count","value":9223372036854775808}])",
     "/accessors/0"},
    {"CountOneTooMany", R"([{"op":"replace","path":"/accessors/0/count","value":4}])",
     "/accessors/0"},
    {"CountZero", R"([{"op":"replace","path":"/accessors/0/count","value":0}])",
     "/accessors/0/count"},
    {"CountText", R"([{"op":"replace","path":"/accessors/0/count","value":"3"}])",
     "/accessors/0/count"},
    {"CountWithoutData",
     R"([{"op":"replace","path":"/accessors/0/count","value":4000000000},
         {"op":"remove","path":"/accessors/0/bufferView"}])",
     "/accessors/0/count"},
    {"OffsetBeyond", R"([{"op":"add","path":"/accessors/0/byteOffset","value":4}])",
     "/accessors/0"},
    {"OffsetNegative", R"([{"op":"add","path":"/accessors/0/byteOffset","value":-4}])",
     "/accessors/0/byteOffset"},
    {"OffsetWraps",
     R"([{"op":"add","path":"/accessors/0/byteOffset","value":18446744073709551612}])",
     "/accessors/0"},
    {"ComponentType", R"([{"op":"replace","path":"/accessors/0/componentType","value":5124}])",
     "/accessors/0/componentType"},
    {"ComponentTypeDouble",
     R"([{"op":"replace","path":"/accessors/0/componentType","value":5130}])",
     "/accessors/0/componentType"},
    {"Type", R"([{"op":"replace","path":"/accessors/0/type","value":"VEC5"}])",
     "/accessors/0/type"},
    {"StrideBelowElement", R"([{"op":"add","path":"/bufferViews/0/byteStride","value":8}])",
     "/accessors/0"},
    {"Normalized", R"([{"op":"add","path":"/accessors/0/normalized","value":1}])",
     "/accessors/0/normalized"},
    {"SparseCount",
     R"([{"op":"add","path":"/accessors/0/sparse","value":{"count":4,
         "indices":{"bufferView":1,"componentType":5123},"values":{"bufferView":0}}}])",
     "/accessors/0/sparse/count"},
    {"SparseIndexType",
     R"([{"op":"add","path":"/accessors/0/sparse","value":{"count":1,
         "indices":{"bufferView":1,"componentType":5126},"values":{"bufferView":0}}}])",
     "/accessors/0/sparse/indices/componentType"},
    {"SparseIndicesBeyondView",
     R"([{"op":"add","path":"/accessors/0/sparse","value":{"count":3,
         "indices":{"bufferView":1,"componentType":5125},"values":{"bufferView":0}}}])",
     "/accessors/0/sparse/indices"},
    {"SparseValuesBeyondView",
     R"([{"op":"add","path":"/accessors/0/sparse","value":{"count":1,
         "indices":{"bufferView":1,"componentType":5123},"values":{"bufferView":1}}}])",
     "/accessors/0/sparse/values"},
    {"SparseNoSuchView",
     R"([{"op":"add","path":"/accessors/0/sparse","value":{"count":1,
         "indices":{"bufferView":9,"componentType":5123},"values":{"bufferView":0}}}])",
     "/accessors/0/sparse/indices/bufferView"},
    {"SparseIndexBeyondCount",
     R"([{"op":"add","path":"/accessors/0/sparse","value":{"count":1,
         "indices":{"bufferView":0,"byteOffset":14,"componentType":5123},
         "values":{"bufferView":0}}}])",
     "/accessors/0/sparse/indices"},
};

constexpr Case k_mesh_cases[] = {
    {"PrimitivesObject", R"([{"op":"replace","path":"/meshes/0/primitives","value":{}}])",
     "/meshes/0/primitives"},
    {"NoAttributes", R"([{"op":"remove","path":"/meshes/0/primitives/0/attributes"}])",
     "/meshes/0/primitives/0"},
    {"NoSuchAttribute",
     R"([{"op":"replace","path":"/meshes/0/primitives/0/attributes/POSITION","value":3}])",
     "/meshes/0/primitives/0/attributes/POSITION"},
    {"PositionTwoComponents",
     R"([{"op":"replace","path":"/meshes/0/primitives/0/attributes/POSITION","value":2}])",
     "/meshes/0/primitives/0/attributes/POSITION"},
    {"CountsDiffer", R"([{"op":"replace","path":"/accessors/2/count","value":2}])",
     "/meshes/0/primitives/0/attributes/TEXCOORD_0"},
    {"TexcoordSetSixteen",
     R"([{"op":"add","path":"/meshes/0/primitives/0/attributes/TEXCOORD_16","value":2}])",
     "/meshes/0/primitives/0/attributes/TEXCOORD_16"},
    {"TexcoordSetHuge",
     R"([{"op":"add","path":"/meshes/0/primitives/0/attributes/TEXCOORD_4000000000","value":2}])",
     "/meshes/0/primitives/0/attributes/TEXCOORD_4000000000"},
    {"NoSuchIndices", R"([{"op":"replace","path":"/meshes/0/primitives/0/indices","value":3}])",
     "/meshes/0/primitives/0/indices"},
    {"IndicesFloat", R"([{"op":"replace","path":"/meshes/0/primitives/0/indices","value":0}])",
     "/meshes/0/primitives/0/indices"},
    {"IndexBeyondVertices",
     R"([{"op":"replace","path":"/accessors/0/count","value":2},
         {"op":"replace","path":"/accessors/2/count","value":2}])",
     "/meshes/0/primitives/0/indices"},
    {"NoSuchMaterial", R"([{"op":"replace","path":"/meshes/0/primitives/0/material","value":1}])",
     "/meshes/0/primitives/0/material"},
    {"ModeSeven", R"([{"op":"add","path":"/meshes/0/primitives/0/mode","value":7}])",
     "/meshes/0/primitives/0/mode"},
    {"TargetBeyond",
     R"([{"op":"add","path":"/meshes/0/primitives/0/targets","value":[{"POSITION":9}]}])",
     "/meshes/0/primitives/0/targets/0/POSITION"},
};

INSTANTIATE_TEST_SUITE_P(Asset, GltfBufferGuard, testing::ValuesIn(k_asset_cases), test::case_name);
INSTANTIATE_TEST_SUITE_P(Buffer, GltfBufferGuard, testing::ValuesIn(k_buffer_cases),
                         test::case_name);
INSTANTIATE_TEST_SUITE_P(Accessor, GltfBufferGuard, testing::ValuesIn(k_accessor_cases),
                         test::case_name);
INSTANTIATE_TEST_SUITE_P(Mesh, GltfBufferGuard, testing::ValuesIn(k_mesh_cases), test::case_name);

}  // namespace
}  // namespace lume::io
