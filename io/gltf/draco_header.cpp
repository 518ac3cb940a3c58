// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/draco_header.h"

#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/decoder_buffer.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/geometry_metadata.h>
#include <draco/metadata/metadata_decoder.h>
#include <fmt/format.h>

#include <stdexcept>

namespace lume::io::gltf {
namespace {

/// glTF asks for this version of the bitstream (KHR_draco_mesh_compression, section "Conformance").
constexpr int k_major = 2;
constexpr int k_minor = 2;
constexpr int k_has_metadata = 0x8000;

/// A flat grid of two million triangles, the kind of mesh that compresses best, has 68 for a byte;
/// this is room for a hundred times as many.
constexpr std::uint64_t k_max_faces_a_byte = 8192;

template <class T>
T take(draco::DecoderBuffer& buffer) {
  T value{};
  if (!buffer.Decode(&value)) {
    throw std::runtime_error("the compressed mesh ends in its header");
  }
  return value;
}

std::uint32_t take_varint(draco::DecoderBuffer& buffer) {
  std::uint32_t value = 0;
  if (!draco::DecodeVarint(&value, &buffer)) {
    throw std::runtime_error("the compressed mesh ends in its header");
  }
  return value;
}

void check_kind(const draco::DracoHeader& header) {
  if (header.version_major != k_major || header.version_minor != k_minor) {
    throw std::runtime_error(fmt::format("is of Draco's bitstream version {}.{}, expected {}.{}",
                                         static_cast<int>(header.version_major),
                                         static_cast<int>(header.version_minor), k_major, k_minor));
  }
  if (header.encoder_type != draco::TRIANGULAR_MESH) {
    throw std::runtime_error("holds points, expected a compressed mesh");
  }
}

/// The first number of a sequential mesh; in an edgebreaker mesh behind its kind of traversal and
/// its number of vertices.
std::uint64_t take_faces(draco::DecoderBuffer& buffer, const draco::DracoHeader& header) {
  if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING) {
    static_cast<void>(take<std::uint8_t>(buffer));
    static_cast<void>(take_varint(buffer));
  } else if (header.encoder_method != draco::MESH_SEQUENTIAL_ENCODING) {
    throw std::runtime_error(
        fmt::format("uses Draco's method {}, which is not known", header.encoder_method));
  }
  return take_varint(buffer);
}

}  // namespace

void check_draco_header(Bytes bytes, std::optional<std::uint64_t> announced_faces) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) {
    throw std::runtime_error("does not begin as a Draco mesh does");
  }
  check_kind(header);
  buffer.set_bitstream_version(DRACO_BITSTREAM_VERSION(k_major, k_minor));
  if ((header.flags & k_has_metadata) != 0) {
    draco::GeometryMetadata metadata;
    if (!draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata)) {
      throw std::runtime_error("the metadata of the compressed mesh are damaged");
    }
  }
  const std::uint64_t faces = take_faces(buffer, header);
  if (announced_faces && faces != *announced_faces) {
    throw std::runtime_error(fmt::format(
        "the indices announce {} triangles, but the compressed mesh {}", *announced_faces, faces));
  }
  if (faces > bytes.size() * k_max_faces_a_byte) {
    throw std::runtime_error(fmt::format("announces {} triangles, more than its {} bytes may hold",
                                         faces, bytes.size()));
  }
}

}  // namespace lume::io::gltf
