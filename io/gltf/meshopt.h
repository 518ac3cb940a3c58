// SPDX-License-Identifier: Apache-2.0
// EXT_meshopt_compression and KHR_meshopt_compression: buffer views whose bytes are compressed by
// the codecs of meshoptimizer. They are decoded before anybody reads them, so that for readers of
// accessors they are like all others.
#pragma once

#include "io/gltf/document.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lume::io::gltf {

enum class MeshoptMode { attributes, triangles, indices };
enum class MeshoptFilter { none, octahedral, quaternion, exponential, color };

/// Where the compressed bytes of a buffer view are, and what they become: `count` elements,
/// `stride` bytes each.
struct MeshoptView {
  std::size_t buffer = 0;
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::uint64_t stride = 0;
  std::uint64_t count = 0;
  MeshoptMode mode = MeshoptMode::attributes;
  MeshoptFilter filter = MeshoptFilter::none;
};

/// The extension of a buffer view, if it has one, with all that can be checked without decoding:
/// the compressed bytes lie in their buffer (of those lengths, in bytes), sizes agree with the
/// view's own and suit mode and filter. Throws Error(scene).
[[nodiscard]] std::optional<MeshoptView> find_meshopt(
    const JsonView& view, const std::vector<std::uint64_t>& buffer_lengths);

/// For each buffer whether nobody reads it, because all views of it are compressed: such a buffer
/// stands in for its decoded bytes, and often has no data at all.
[[nodiscard]] std::vector<bool> find_placeholders(const JsonView& root);

/// The count * stride bytes of a view. Indices are not looked at: that is for those who know the
/// vertices. Throws std::runtime_error with the reason alone.
[[nodiscard]] std::vector<std::byte> decode_meshopt(Bytes data, const MeshoptView& view);

/// Decodes all compressed views, on several threads, and points document.model at the result.
/// Throws Error(scene).
void decode_meshopt_views(Document& document);

}  // namespace lume::io::gltf
