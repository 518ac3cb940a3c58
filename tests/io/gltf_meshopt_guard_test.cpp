// SPDX-License-Identifier: Apache-2.0
// Files with EXT_meshopt_compression or KHR_meshopt_compression: they load without their fallback,
// and what breaks the extensions' rules is refused with its place.
#include "tests/io/gltf_guard.h"

#include <gmock/gmock.h>
#include <meshoptimizer.h>

namespace lume::io {
namespace {

using Stream = std::vector<std::uint8_t>;

Stream encode_vertices(const void* data, std::size_t count, std::size_t stride) {
  Stream stream(meshopt_encodeVertexBufferBound(count, stride));
  stream.resize(meshopt_encodeVertexBuffer(stream.data(), stream.size(), data, count, stride));
  return stream;
}

/// The triangle file with its positions (view 0) and indices (view 1) compressed; the buffer that
/// they would be in has no data.
nlohmann::json compressed_file(const std::string& name) {
  test::GltfFile file = test::triangle_file();
  const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const unsigned int indices[] = {0, 1, 2};
  Stream triangles(meshopt_encodeIndexBufferBound(3, 3));
  triangles.resize(meshopt_encodeIndexBuffer(triangles.data(), triangles.size(), indices, 3));
  const Stream vertices = encode_vertices(positions, 3, 12);
  const auto add = [&](std::size_t view, const Stream& stream, const nlohmann::json& layout) {
    nlohmann::json extension = layout;
    extension["buffer"] = 0;
    extension["byteOffset"] = file.append(stream);
    extension["byteLength"] = stream.size();
    auto& json = file.json["bufferViews"][view];
    json["buffer"] = 1;
    json["extensions"][name] = extension;
  };
  add(0, vertices, {{"byteStride", 12}, {"count", 3}, {"mode", "ATTRIBUTES"}});
  add(1, triangles, {{"byteStride", 2}, {"count", 3}, {"mode", "TRIANGLES"}});
  file.json["extensionsRequired"] = {name};
  nlohmann::json json = file.complete();
  json["buffers"].push_back({{"byteLength", 42}});
  return json;
}

TEST(GltfMeshopt, FileWithoutFallback_Loads) {
  const tests::TemporaryFolder folder;
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    test::write_bytes(folder / "a.gltf", compressed_file(name).dump());
    const LoadedScene loaded = load_gltf(folder / "a.gltf");
    const auto* mesh = loaded.scene.world.objects.at(0).geometries.at(0).mesh();
    using geometry::Vec3;
    EXPECT_THAT(mesh->positions, testing::ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
    EXPECT_THAT(mesh->triangles, testing::ElementsAre(geometry::UVec3(0, 1, 2)));
    EXPECT_EQ(loaded.extensions.at(1).support, Support::full);
  }
}

class GltfMeshoptGuard : public testing::TestWithParam<test::GuardCase> {};

TEST_P(GltfMeshoptGuard, BrokenFile_IsSceneErrorWithPointer) {
  const nlohmann::json file = compressed_file("KHR_meshopt_compression");
  test::expect_scene_error(file.patch(nlohmann::json::parse(GetParam().patch)), GetParam().pointer);
}

constexpr test::GuardCase k_cases[] = {
    {"NoMode",
     R"([{"op":"remove","path":"/bufferViews/0/extensions/KHR_meshopt_compression/mode"}])",
     "/bufferViews/0/extensions/KHR_meshopt_compression"},
    {"ModeUnknown",
     R"([{"op":"replace","path":"/bufferViews/0/extensions/KHR_meshopt_compression/mode","value":"POINTS"}])",
     "/bufferViews/0/extensions/KHR_meshopt_compression/mode"},
    {"FilterUnknown",
     R"([{"op":"add","path":"/bufferViews/0/extensions/KHR_meshopt_compression/filter","value":"BLUR"}])",
     "/bufferViews/0/extensions/KHR_meshopt_compression/filter"},
    {"FilterNeedsStrideEight",
     R"([{"op":"add","path":"/bufferViews/0/extensions/KHR_meshopt_compression/filter","value":"QUATERNION"}])",
     "/bufferViews/0/extensions/KHR_meshopt_compression/byteStride"},
    {"FilterNeedsStrideFourOrEight",
     R"([{"op":"add","path":"/bufferViews/0/extensions/KHR_meshopt_compression/filter","value":"COLOR"}])",
     "/bufferViews/0/extensions/KHR_meshopt_compression/byteStride"},
    {"FilterOnIndices",
     R"([{"op":"add","path":"/bufferViews/1/extensions/KHR_meshopt_compression/filter","value":"EXPONENTIAL"}])",
     "/bufferViews/1/extensions/KHR_meshopt_compression/filter"},
    {"NoSuchBuffer",
     R"([{"op":"replace","path":"/bufferViews/0/extensions/KHR_meshopt_compression/buffer","value":2}])",
     "/bufferViews/0/extensions/KHR_meshopt_compression/buffer"},
    {"BytesBeyondBuffer",
     R"([{"op":"replace","path":"/bufferViews/0/extensions/KHR_meshopt_compression/byteLength","value":4000000}])",
     "/bufferViews/0/extensions/KHR_meshopt_compression"},
    {"OffsetWraps",
     R"([{"op":"replace","path":"/bufferViews/0/extensions/KHR_meshopt_compression/byteOffset","value":18446744073709551615}])",
     "/bufferViews/0/extensions/KHR_meshopt_compression"},
    {"StrideNotOfFour",
     R"([{"op":"replace","path":"/bufferViews/0/extensions/KHR_meshopt_compression/byteStride","value":6}])",
     "/bufferViews/0/extensions/KHR_meshopt_compression/byteStride"},
    {"StrideOfIndices",
     R"([{"op":"replace","path":"/bufferViews/1/extensions/KHR_meshopt_compression/byteStride","value":8}])",
     "/bufferViews/1/extensions/KHR_meshopt_compression/byteStride"},
    {"StrideZero",
     R"([{"op":"replace","path":"/bufferViews/0/extensions/KHR_meshopt_compression/byteStride","value":0}])",
     "/bufferViews/0/extensions/KHR_meshopt_compression/byteStride"},
    {"CountZero",
     R"([{"op":"replace","path":"/bufferViews/0/extensions/KHR_meshopt_compression/count","value":0}])",
     "/bufferViews/0/extensions/KHR_meshopt_compression/count"},
    {"CountHuge",
     R"([{"op":"replace","path":"/bufferViews/0/extensions/KHR_meshopt_compression/count","value":9223372036854775807}])",
     "/bufferViews/0/extensions/KHR_meshopt_compression/count"},
    {"CountNotOfTriangles",
     R"([{"op":"replace","path":"/bufferViews/1/extensions/KHR_meshopt_compression/count","value":4}])",
     "/bufferViews/1/extensions/KHR_meshopt_compression/count"},
    {"ViewOfOtherLength", R"([{"op":"replace","path":"/bufferViews/0/byteLength","value":32}])",
     "/bufferViews/0/byteLength"},
    {"ViewOfOtherStride", R"([{"op":"add","path":"/bufferViews/0/byteStride","value":16}])",
     "/bufferViews/0/extensions/KHR_meshopt_compression/byteStride"},
    {"DataDamaged",
     R"([{"op":"replace","path":"/bufferViews/0/extensions/KHR_meshopt_compression/byteLength","value":40}])",
     "/bufferViews/0/extensions"},
    {"DataOfOtherMode",
     R"([{"op":"replace","path":"/bufferViews/0/extensions/KHR_meshopt_compression/byteOffset","value":0}])",
     "/bufferViews/0/extensions"},
    {"BothExtensions",
     R"([{"op":"add","path":"/bufferViews/0/extensions/EXT_meshopt_compression","value":{}}])",
     "/bufferViews/0/extensions/KHR_meshopt_compression"},
    {"PlainViewOfPlaceholder",
     R"([{"op":"add","path":"/bufferViews/-","value":{"buffer":1,"byteLength":4}}])", "/buffers/1"},
};

INSTANTIATE_TEST_SUITE_P(Rules, GltfMeshoptGuard, testing::ValuesIn(k_cases), test::case_name);

}  // namespace
}  // namespace lume::io
