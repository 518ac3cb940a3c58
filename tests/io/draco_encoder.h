// SPDX-License-Identifier: Apache-2.0
// glTF files of one primitive that Draco compressed.
#pragma once

#include "geometry/mesh.h"
#include "tests/support/gltf_file.h"

#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace lume::test {

template <class T>
std::uint32_t add_draco_attribute(draco::Mesh& mesh, draco::GeometryAttribute::Type type,
                                  draco::DataType data_type, int width,
                                  const std::vector<T>& values) {
  draco::GeometryAttribute attribute;
  attribute.Init(type, nullptr, static_cast<std::int8_t>(width), data_type,
                 data_type == draco::DT_UINT8, sizeof(T), 0);
  const int id = mesh.AddAttribute(attribute, true, static_cast<std::uint32_t>(values.size()));
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), &values[i]);
  }
  return mesh.attribute(id)->unique_id();
}

/// A glTF file of one compressed primitive, without loss.
struct CompressedFile {
  GltfFile file;
  std::size_t offset = 0;  ///< of the compressed bytes in the buffer
  std::size_t size = 0;
};

inline CompressedFile compress(const geometry::Mesh& mesh, draco::MeshEncoderMethod method) {
  draco::Mesh source;
  source.set_num_points(static_cast<std::uint32_t>(mesh.positions.size()));
  std::vector<std::array<std::uint8_t, 4>> colors;
  for (const geometry::Vec4& color : mesh.colors) {
    colors.emplace_back();
    for (int c = 0; c < 4; ++c) {
      colors.back()[static_cast<std::size_t>(c)] =
          static_cast<std::uint8_t>(std::lround(color[c] * 255.0f));
    }
  }
  using Attribute = draco::GeometryAttribute;
  nlohmann::json ids;
  ids["POSITION"] =
      add_draco_attribute(source, Attribute::POSITION, draco::DT_FLOAT32, 3, mesh.positions);
  ids["NORMAL"] =
      add_draco_attribute(source, Attribute::NORMAL, draco::DT_FLOAT32, 3, mesh.normals);
  ids["TEXCOORD_0"] =
      add_draco_attribute(source, Attribute::TEX_COORD, draco::DT_FLOAT32, 2, mesh.texcoords[0]);
  ids["COLOR_0"] = add_draco_attribute(source, Attribute::COLOR, draco::DT_UINT8, 4, colors);
  for (const geometry::UVec3& t : mesh.triangles) {
    source.AddFace({draco::PointIndex(t.x), draco::PointIndex(t.y), draco::PointIndex(t.z)});
  }
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  encoder.SetTrackEncodedProperties(true);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(source, &buffer).ok());

  CompressedFile result;
  result.size = buffer.size();
  const std::size_t view =
      result.file.add_view(std::vector<char>(buffer.data(), buffer.data() + buffer.size()));
  nlohmann::json primitive;
  const auto add_accessor = [&](const char* type, int component, std::size_t count) {
    return result.file.add("accessors",
                           {{"componentType", component}, {"count", count}, {"type", type}});
  };
  const std::size_t points = encoder.num_encoded_points();
  primitive["attributes"] = {{"POSITION", add_accessor("VEC3", 5126, points)},
                             {"NORMAL", add_accessor("VEC3", 5126, points)},
                             {"TEXCOORD_0", add_accessor("VEC2", 5126, points)},
                             {"COLOR_0", add_accessor("VEC4", 5121, points)}};
  result.file.json["accessors"][3]["normalized"] = true;
  primitive["indices"] = add_accessor("SCALAR", 5125, 3 * encoder.num_encoded_faces());
  primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", view},
                                                           {"attributes", ids}};
  result.file.add("meshes", {{"primitives", {primitive}}});
  result.file.add("nodes", {{"mesh", 0}});
  result.file.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return result;
}

}  // namespace lume::test
