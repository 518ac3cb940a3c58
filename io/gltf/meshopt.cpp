// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/meshopt.h"

#include "geometry/parallel.h"
#include "io/gltf/meshopt_color.h"
#include "io/gltf/meshopt_v1.h"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <stdexcept>
#include <utility>

namespace lume::io::gltf {
namespace {

/// The first byte of a stream: the mode above, the version below.
struct Header {
  unsigned magic = 0;
  unsigned last_version = 0;  ///< that can be decoded
};

Header header_of(MeshoptMode mode) {
  switch (mode) {
    case MeshoptMode::attributes:
      return {0xA, 1};
    case MeshoptMode::triangles:
      return {0xE, 1};
    case MeshoptMode::indices:
      return {0xD, 1};
  }
  return {};
}

/// The version of the stream.
unsigned check_header(Bytes data, MeshoptMode mode) {
  if (data.empty()) {
    throw std::runtime_error("has no bytes");
  }
  const auto first = std::to_integer<unsigned>(data.front());
  const Header header = header_of(mode);
  if (first >> 4 != header.magic) {
    throw std::runtime_error(
        fmt::format("begins with the byte {:#04x}, expected {:#04x} or {:#04x}", first,
                    header.magic << 4, (header.magic << 4) | header.last_version));
  }
  const unsigned version = first & 15u;
  if (version > header.last_version) {
    throw std::runtime_error(fmt::format("is of version {} of its codec, expected {} at most",
                                         version, header.last_version));
  }
  return version;
}

/// The fewest bytes that may stand for `view`, so that nothing is allocated for a count that cannot
/// be true. Attributes: two bits for 16 elements of one byte each, in version 1 two bits for a
/// block of up to 8 KiB; triangles and indices take a byte each and have a tail.
std::uint64_t fewest_bytes(const MeshoptView& view, unsigned version) {
  switch (view.mode) {
    case MeshoptMode::attributes:
      return view.count * view.stride / (version == 0 ? 64 : 1024);
    case MeshoptMode::triangles:
      return view.count / 3 + 17;
    case MeshoptMode::indices:
      return view.count + 5;
  }
  return 0;
}

int decode_stream(std::byte* out, Bytes data, const MeshoptView& view, unsigned version) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(data.data());
  switch (view.mode) {
    case MeshoptMode::attributes:
      if (version == 1) {
        return decode_meshopt_v1(out, view.count, view.stride, data) ? 0 : -1;
      }
      return meshopt_decodeVertexBuffer(out, view.count, view.stride, bytes, data.size());
    case MeshoptMode::triangles:
      return meshopt_decodeIndexBuffer(out, view.count, view.stride, bytes, data.size());
    case MeshoptMode::indices:
      return meshopt_decodeIndexSequence(out, view.count, view.stride, bytes, data.size());
  }
  return -1;
}

void apply_filter(std::byte* data, const MeshoptView& view) {
  switch (view.filter) {
    case MeshoptFilter::none:
      return;
    case MeshoptFilter::octahedral:
      return meshopt_decodeFilterOct(data, view.count, view.stride);
    case MeshoptFilter::quaternion:
      return meshopt_decodeFilterQuat(data, view.count, view.stride);
    case MeshoptFilter::exponential:
      return meshopt_decodeFilterExp(data, view.count, view.stride);
    case MeshoptFilter::color:
      return decode_meshopt_colors(data, view.count, view.stride);
  }
}

}  // namespace

std::vector<std::byte> decode_meshopt(Bytes data, const MeshoptView& view) {
  const unsigned version = check_header(data, view.mode);
  if (data.size() < fewest_bytes(view, version)) {
    throw std::runtime_error(fmt::format("its {} bytes are too few for {} elements of {} bytes",
                                         data.size(), view.count, view.stride));
  }
  std::vector<std::byte> result(view.count * view.stride);
  if (decode_stream(result.data(), data, view, version) != 0) {
    throw std::runtime_error("its compressed bytes are damaged or cut short");
  }
  apply_filter(result.data(), view);
  return result;
}

void decode_meshopt_views(Document& document) {
  std::vector<std::uint64_t> lengths;
  lengths.reserve(document.buffers.size());
  for (const JsonView& buffer : document.root().items("buffers")) {
    lengths.push_back(buffer.require("byteLength").integer());
  }
  const std::vector<JsonView> views = document.root().items("bufferViews");
  std::vector<std::pair<std::size_t, MeshoptView>> compressed;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (const auto view = find_meshopt(views[i], lengths)) {
      compressed.emplace_back(i, *view);
    }
  }
  std::vector<std::vector<std::byte>> decoded(compressed.size());
  geometry::parallel_for(compressed.size(), [&](std::size_t i) {
    const auto& [index, view] = compressed[i];
    try {
      decoded[i] =
          decode_meshopt(document.buffers[view.buffer].subspan(view.offset, view.length), view);
    } catch (const std::exception& reason) {
      views[index].require("extensions").fail(reason.what());
    }
  });
  for (std::size_t i = 0; i < compressed.size(); ++i) {
    tinygltf::BufferView& view = document.model.bufferViews[compressed[i].first];
    view.buffer = static_cast<int>(document.buffers.size());
    view.byteOffset = 0;
    document.buffers.emplace_back(document.loaded.emplace_back(std::move(decoded[i])));
  }
}

}  // namespace lume::io::gltf
