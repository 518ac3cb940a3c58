// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/draco.h"

#include "geometry/parallel.h"
#include "io/error.h"
#include "io/gltf/component.h"
#include "io/gltf/draco_header.h"
#include "io/gltf/triangulate.h"

#include <draco/compression/decode.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace lume::io::gltf {
namespace {

constexpr const char* k_extension = "KHR_draco_mesh_compression";

/// A compressed primitive, in the file and in tinygltf's reading of it.
struct Job {
  JsonView json;
  JsonView extension;
  tinygltf::Primitive* primitive = nullptr;
};

/// Packed values that take the place of an accessor's.
struct Values {
  std::string attribute;  ///< empty: the indices
  tinygltf::Accessor accessor;
  std::vector<std::byte> bytes;
};

[[noreturn]] void refuse(const std::string& reason) { throw std::runtime_error(reason); }

template <class T>
std::vector<std::byte> convert(const draco::PointAttribute& attribute, std::uint32_t points) {
  const auto width = static_cast<std::size_t>(attribute.num_components());
  std::vector<std::byte> bytes(points * width * sizeof(T));
  std::vector<T> value(width);
  for (std::uint32_t point = 0; point < points; ++point) {
    const draco::AttributeValueIndex index = attribute.mapped_index(draco::PointIndex(point));
    if (index.value() >= attribute.size() ||
        !attribute.ConvertValue<T>(index, attribute.num_components(), value.data())) {
      refuse(fmt::format("the value of point {} is not there or does not fit its accessor", point));
    }
    std::memcpy(bytes.data() + point * width * sizeof(T), value.data(), width * sizeof(T));
  }
  return bytes;
}

std::vector<std::byte> convert_to(Component component, const draco::PointAttribute& attribute,
                                  std::uint32_t points) {
  switch (component) {
    case Component::i8:
      return convert<std::int8_t>(attribute, points);
    case Component::u8:
      return convert<std::uint8_t>(attribute, points);
    case Component::i16:
      return convert<std::int16_t>(attribute, points);
    case Component::u16:
      return convert<std::uint16_t>(attribute, points);
    case Component::u32:
      return convert<std::uint32_t>(attribute, points);
    case Component::f32:
      return convert<float>(attribute, points);
  }
  return {};
}

/// Integers may be read as floats, or as integers of another width where that does not change what
/// they stand for.
void check_component_types(const std::string& name, const draco::PointAttribute& attribute,
                           const tinygltf::Accessor& accessor) {
  const draco::DataType type = attribute.data_type();
  const bool holds_floats = type == draco::DT_FLOAT32 || type == draco::DT_FLOAT64;
  const auto component = static_cast<std::uint64_t>(accessor.componentType);
  if (static_cast<Component>(component) == Component::f32) {
    return;
  }
  if (holds_floats || (accessor.normalized && draco::DataTypeLength(type) !=
                                                  static_cast<int>(component_size(component)))) {
    refuse(fmt::format("{} has the componentType {}, which is not that of the compressed mesh",
                       name, component));
  }
}

/// One attribute of the compressed mesh, in the form that the accessor announces.
Values read_attribute(const draco::Mesh& mesh, const std::string& name, std::uint64_t id,
                      const tinygltf::Accessor& accessor) {
  const draco::PointAttribute* attribute =
      id > 0xFFFFFFFF ? nullptr : mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
  if (attribute == nullptr) {
    refuse(fmt::format("{} is attribute {}, which the compressed mesh does not have", name, id));
  }
  if (accessor.count != mesh.num_points()) {
    refuse(fmt::format("{} has {} elements, but the compressed mesh {} points", name,
                       accessor.count, mesh.num_points()));
  }
  const int components =
      tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  if (attribute->num_components() != components) {
    refuse(fmt::format("{} has {} components, but {} in the compressed mesh", name, components,
                       static_cast<int>(attribute->num_components())));
  }
  check_component_types(name, *attribute, accessor);
  Values values{name, accessor, {}};
  values.bytes =
      convert_to(static_cast<Component>(accessor.componentType), *attribute, mesh.num_points());
  return values;
}

/// The faces as indices of 32 bits.
Values read_faces(const draco::Mesh& mesh) {
  Values values;
  values.accessor.componentType = static_cast<int>(Component::u32);
  values.accessor.type = TINYGLTF_TYPE_SCALAR;
  values.accessor.count = std::size_t{3} * mesh.num_faces();
  values.bytes.resize(values.accessor.count * sizeof(std::uint32_t));
  std::byte* out = values.bytes.data();
  for (std::uint32_t face = 0; face < mesh.num_faces(); ++face) {
    for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(face))) {
      const std::uint32_t index = corner.value();
      if (index >= mesh.num_points()) {
        refuse(
            fmt::format("face {} of the compressed mesh has the corner {}, expected one below {}",
                        face, index, mesh.num_points()));
      }
      std::memcpy(out, &index, sizeof(index));
      out += sizeof(index);
    }
  }
  return values;
}

/// How many faces the primitive's indices announce; nothing where they do not tell: the faces of a
/// strip may be more or fewer than its indices.
std::optional<std::uint64_t> announced_faces(const Document& document, const Job& job) {
  const auto indices = job.json.index_of("indices", document.model.accessors.size(), "accessors");
  if (!indices || static_cast<Mode>(job.primitive->mode) != Mode::triangles) {
    return std::nullopt;
  }
  const std::size_t count = document.model.accessors[*indices].count;
  if (count % 3 != 0) {
    refuse(fmt::format("the accessor of indices has {} elements, expected a multiple of 3", count));
  }
  return count / 3;
}

std::unique_ptr<draco::Mesh> decode_mesh(Bytes bytes, std::optional<std::uint64_t> faces) {
  check_draco_header(bytes, faces);
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) {
    std::string reason = decoded.status().error_msg_string();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    refuse("the compressed mesh cannot be decoded: " + (reason.empty() ? "damaged data" : reason));
  }
  std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
  if (faces && mesh->num_faces() != *faces) {
    refuse(fmt::format("the indices announce {} triangles, but the compressed mesh has {}", *faces,
                       mesh->num_faces()));
  }
  return mesh;
}

std::vector<Values> decode(const Document& document, const Job& job) {
  const JsonView view = job.extension.require("bufferView");
  const std::size_t index = view.index(document.model.bufferViews.size(), "bufferViews");
  const auto mode = static_cast<Mode>(job.primitive->mode);
  if (mode != Mode::triangles && mode != Mode::triangle_strip) {
    refuse("expected a primitive of triangles or a triangle strip");
  }
  const std::unique_ptr<draco::Mesh> mesh =
      decode_mesh(document.view_bytes(index), announced_faces(document, job));
  std::vector<Values> result;
  const JsonView attributes = job.extension.require("attributes");
  for (const std::string& name : attributes.keys()) {
    const auto it = job.primitive->attributes.find(name);
    if (it == job.primitive->attributes.end()) {
      attributes.require(name).fail("expected an attribute that the primitive has, too");
    }
    const auto accessor = static_cast<std::size_t>(it->second);
    result.push_back(read_attribute(*mesh, name, attributes.require(name).integer(),
                                    document.model.accessors[accessor]));
  }
  result.push_back(read_faces(*mesh));
  return result;
}

std::vector<Job> find_compressed(Document& document) {
  std::vector<Job> jobs;
  const std::vector<JsonView> meshes = document.root().items("meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const std::vector<JsonView> primitives = meshes[m].items("primitives");
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      if (const auto extension = primitives[p].extension(k_extension)) {
        jobs.push_back({primitives[p], *extension, &document.model.meshes[m].primitives[p]});
      }
    }
  }
  return jobs;
}

/// Adds buffer, view and accessor; returns the accessor's index.
int add_accessor(Document& document, Values& values) {
  tinygltf::BufferView view;
  view.buffer = static_cast<int>(document.buffers.size());
  view.byteLength = values.bytes.size();
  document.buffers.emplace_back(document.loaded.emplace_back(std::move(values.bytes)));
  tinygltf::Accessor accessor = values.accessor;
  accessor.bufferView = static_cast<int>(document.model.bufferViews.size());
  accessor.byteOffset = 0;
  accessor.sparse.isSparse = false;
  document.model.bufferViews.push_back(view);
  document.model.accessors.push_back(accessor);
  return static_cast<int>(document.model.accessors.size()) - 1;
}

}  // namespace

void hide_compressed_indices(Json& structure) {
  if (!structure.contains("meshes")) {
    return;
  }
  for (Json& mesh : structure["meshes"]) {
    for (Json& primitive : mesh["primitives"]) {
      if (primitive.contains("extensions") && primitive["extensions"].contains(k_extension)) {
        primitive.erase("indices");
      }
    }
  }
}

void decode_draco_primitives(Document& document) {
  const std::vector<Job> jobs = find_compressed(document);
  std::vector<std::vector<Values>> decoded(jobs.size());
  geometry::parallel_for(jobs.size(), [&](std::size_t i) {
    try {
      decoded[i] = decode(document, jobs[i]);
    } catch (const Error&) {
      throw;
    } catch (const std::exception& reason) {
      jobs[i].extension.fail(reason.what());
    }
  });
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    tinygltf::Primitive& primitive = *jobs[i].primitive;
    for (Values& values : decoded[i]) {
      int& accessor =
          values.attribute.empty() ? primitive.indices : primitive.attributes[values.attribute];
      accessor = add_accessor(document, values);
    }
    primitive.mode = static_cast<int>(Mode::triangles);
  }
}

}  // namespace lume::io::gltf
