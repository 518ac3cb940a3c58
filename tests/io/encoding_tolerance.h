// SPDX-License-Identifier: Apache-2.0
// How far the values of an encoded model may be from the plain one, by what its file says.
#pragma once

#include "io/gltf/load_gltf.h"

#include <draco/attributes/attribute_octahedron_transform.h>
#include <draco/attributes/attribute_quantization_transform.h>
#include <draco/compression/decode.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace lume::test {

/// How far a value may be from what was encoded.
struct Tolerance {
  double position = 0.0;  ///< in the world
  double normal = 0.0;
  double uv = 0.0;
};

inline std::string read_text(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

inline double largest_scale(const io::LoadedScene& loaded) {
  double result = 0.0;
  for (const geometry::Instance& instance : loaded.scene.world.instances) {
    for (int axis = 0; axis < 3; ++axis) {
      geometry::DVec3 unit(0.0);
      unit[axis] = 1.0;
      result = std::max(result, length(instance.transform.vector_to_world(unit)));
    }
  }
  return result;
}

/// Half a step along each of `axes` axes.
inline double half_diagonal(double step, int axes) { return 0.5 * step * std::sqrt(axes); }

/// A unit vector whose octahedral coordinates, from -1 to 1, are rounded to `bits`.
inline double octahedral_error(int bits) { return 2.0 * 2.0 / (std::exp2(bits) - 2.0); }

inline void add_quantization(const draco::PointAttribute& attribute, double scale,
                             Tolerance& tolerance) {
  if (attribute.attribute_type() == draco::GeometryAttribute::NORMAL) {
    draco::AttributeOctahedronTransform transform;
    ASSERT_TRUE(transform.InitFromAttribute(attribute));
    tolerance.normal = std::max(tolerance.normal, octahedral_error(transform.quantization_bits()));
    return;
  }
  draco::AttributeQuantizationTransform transform;
  ASSERT_TRUE(transform.InitFromAttribute(attribute));
  const double step =
      static_cast<double>(transform.range()) / (std::exp2(transform.quantization_bits()) - 1.0);
  if (attribute.attribute_type() == draco::GeometryAttribute::POSITION) {
    tolerance.position = std::max(tolerance.position, half_diagonal(step * scale, 3));
  } else {
    tolerance.uv = std::max(tolerance.uv, half_diagonal(step, 2));
  }
}

/// The steps in the compressed meshes of a .gltf file with one buffer.
inline Tolerance draco_tolerance(const std::filesystem::path& path) {
  const nlohmann::json json = nlohmann::json::parse(read_text(path));
  const std::string bytes =
      read_text(path.parent_path() / json["buffers"][0]["uri"].get<std::string>());
  const double scale = largest_scale(io::load_gltf(path, {.decode_images = false}));
  Tolerance tolerance;
  for (const auto& primitive : json["meshes"][0]["primitives"]) {
    const auto& extension = primitive["extensions"]["KHR_draco_mesh_compression"];
    const auto& view = json["bufferViews"][extension["bufferView"].get<std::size_t>()];
    draco::DecoderBuffer buffer;
    buffer.Init(bytes.data() + view.value("byteOffset", std::size_t{0}),
                view["byteLength"].get<std::size_t>());
    draco::Decoder decoder;
    for (const auto type : {draco::GeometryAttribute::POSITION, draco::GeometryAttribute::NORMAL,
                            draco::GeometryAttribute::TEX_COORD}) {
      decoder.SetSkipAttributeTransform(type);
    }
    const auto mesh = decoder.DecodeMeshFromBuffer(&buffer).value();
    for (int i = 0; i < mesh->num_attributes(); ++i) {
      add_quantization(*mesh->attribute(i), scale, tolerance);
    }
  }
  return tolerance;
}

/// Integers that are scaled by the node, bytes for normals, integers scaled by the texture's
/// transform (KHR_mesh_quantization).
inline Tolerance integer_tolerance(const std::filesystem::path& path) {
  const io::LoadedScene loaded = io::load_gltf(path, {.decode_images = false});
  Tolerance tolerance;
  tolerance.position = half_diagonal(largest_scale(loaded), 3);
  tolerance.normal = 2.0 * half_diagonal(1.0 / 127.0, 3);
  for (const shading::Material& material : loaded.scene.materials) {
    const geometry::Vec2 scale = material.base_color_texture.transform.scale;
    if (scale != geometry::Vec2(1.0f)) {
      tolerance.uv = std::max(tolerance.uv, half_diagonal(std::max(scale.x, scale.y), 2));
    }
  }
  return tolerance;
}

}  // namespace lume::test
