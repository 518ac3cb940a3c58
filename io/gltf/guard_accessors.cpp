// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/component.h"
#include "io/gltf/guards.h"
#include "io/gltf/meshopt.h"

#include <fmt/format.h>

#include <set>

namespace lume::io::gltf {
namespace {

/// An accessor without a buffer view is all zeros, whatever its count: no bytes stand behind it.
/// Such a count is believed up to this many elements (a quarter of a gigabyte at most).
constexpr std::uint64_t k_max_zeros = std::uint64_t{1} << 24;
/// The same for what Draco compressed, whose values come from elsewhere.
constexpr std::uint64_t k_max_compressed = std::uint64_t{1} << 27;
/// tinygltf keeps the numbers of sparse accessors in an int.
constexpr std::uint64_t k_max_int = 0x7FFFFFFF;

struct View {
  std::uint64_t length = 0;
  std::uint64_t stride = 0;  ///< 0: elements are packed
};

/// `offset + length <= limit`, without overflow.
bool fits(std::uint64_t offset, std::uint64_t length, std::uint64_t limit) {
  return offset <= limit && length <= limit - offset;
}

std::vector<std::uint64_t> check_buffers(const JsonView& root) {
  std::vector<std::uint64_t> lengths;
  for (const JsonView& buffer : root.items("buffers")) {
    lengths.push_back(buffer.require("byteLength").integer());
    static_cast<void>(buffer.text_or("uri", ""));
  }
  return lengths;
}

View check_view(const JsonView& view, const std::vector<std::uint64_t>& buffers) {
  const std::size_t buffer = view.require("buffer").index(buffers.size(), "buffers");
  const std::uint64_t offset = view.integer_or("byteOffset", 0);
  const std::uint64_t length = view.require("byteLength").integer();
  if (!fits(offset, length, buffers[buffer])) {
    view.fail(fmt::format("its {} bytes from offset {} do not fit into buffer {} of {} bytes",
                          length, offset, buffer, buffers[buffer]));
  }
  static_cast<void>(find_meshopt(view, buffers));
  const std::optional<JsonView> stride = view.find("byteStride");
  if (stride) {
    const std::uint64_t value = stride->integer();
    if (value < 4 || value > 252 || value % 4 != 0) {
      stride->fail(fmt::format("is {}, expected a multiple of 4 in [4, 252]", value));
    }
  }
  return {length, stride ? stride->integer() : 0};
}

/// That `count` elements of `size` bytes, `stride` apart, lie in the view.
void check_extent(const JsonView& at, const View& view, std::uint64_t offset, std::uint64_t count,
                  std::uint64_t size, std::uint64_t stride) {
  const bool first_fits = fits(offset, size, view.length);
  if (!first_fits || count - 1 > (view.length - offset - size) / stride) {
    at.fail(fmt::format(
        "its {} elements of {} bytes, {} apart from offset {}, do not fit into a view of {} bytes",
        count, size, stride, offset, view.length));
  }
}

std::uint64_t check_component_type(const JsonView& object) {
  const JsonView type = object.require("componentType");
  const std::uint64_t size = component_size(type.integer());
  if (size == 0) {
    type.fail(fmt::format("is {}, expected 5120, 5121, 5122, 5123, 5125 or 5126", type.integer()));
  }
  return size;
}

const View& view_of(const JsonView& object, const std::vector<View>& views) {
  return views[object.require("bufferView").index(views.size(), "bufferViews")];
}

std::uint64_t small_offset(const JsonView& object) {
  const std::uint64_t offset = object.integer_or("byteOffset", 0);
  if (offset > k_max_int) {
    object.require("byteOffset").fail("is beyond 2 GiB, the most that is read in sparse accessors");
  }
  return offset;
}

void check_sparse(const JsonView& sparse, std::uint64_t count, std::uint64_t element_size,
                  const std::vector<View>& views) {
  const JsonView sparse_count = sparse.require("count");
  const std::uint64_t replaced = sparse_count.integer();
  if (replaced < 1 || replaced > count || replaced > k_max_int) {
    sparse_count.fail(
        fmt::format("is {}, expected 1 to {}, the accessor's count", replaced, count));
  }
  const JsonView indices = sparse.require("indices");
  const std::uint64_t index_size = check_component_type(indices);
  const auto index_type = static_cast<Component>(indices.require("componentType").integer());
  if (index_type != Component::u8 && index_type != Component::u16 && index_type != Component::u32) {
    indices.require("componentType").fail("expected an unsigned type: 5121, 5123 or 5125");
  }
  check_extent(indices, view_of(indices, views), small_offset(indices), replaced, index_size,
               index_size);
  const JsonView values = sparse.require("values");
  check_extent(values, view_of(values, views), small_offset(values), replaced, element_size,
               element_size);
}

/// `max_zeros`: the count that is believed without any data.
void check_accessor(const JsonView& accessor, const std::vector<View>& views,
                    std::uint64_t max_zeros) {
  const std::uint64_t component_bytes = check_component_type(accessor);
  const JsonView type_name = accessor.require("type");
  const ElementType type = element_type(type_name.text());
  if (type.columns == 0) {
    type_name.fail("is \"" + type_name.text().substr(0, 20) +
                   "\", expected SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4");
  }
  static_cast<void>(accessor.boolean_or("normalized", false));
  const std::uint64_t size = type.size(component_bytes);
  const JsonView count = accessor.require("count");
  if (count.integer() < 1) {
    count.fail("is 0, expected at least 1");
  }
  const std::uint64_t offset = accessor.integer_or("byteOffset", 0);
  if (accessor.has("bufferView")) {
    const View& view = view_of(accessor, views);
    if (view.stride != 0 && view.stride < size) {
      accessor.fail(fmt::format("its elements have {} bytes, but its view's byteStride is {}", size,
                                view.stride));
    }
    check_extent(accessor, view, offset, count.integer(), size,
                 view.stride != 0 ? view.stride : size);
  } else if (count.integer() > max_zeros) {
    count.fail(fmt::format("is {} without any data, expected at most {} zeros", count.integer(),
                           max_zeros));
  }
  if (const std::optional<JsonView> sparse = accessor.find("sparse")) {
    check_sparse(*sparse, count.integer(), size, views);
  }
}

/// The accessors of indices that Draco compressed.
std::set<std::uint64_t> find_compressed_indices(const JsonView& root) {
  std::set<std::uint64_t> accessors;
  for (const JsonView& mesh : root.items("meshes")) {
    for (const JsonView& primitive : mesh.items("primitives")) {
      if (primitive.extension("KHR_draco_mesh_compression") && primitive.has("indices")) {
        accessors.insert(primitive.require("indices").integer());
      }
    }
  }
  return accessors;
}

}  // namespace

void check_accessors(const JsonView& root) {
  const std::vector<std::uint64_t> buffers = check_buffers(root);
  std::vector<View> views;
  for (const JsonView& view : root.items("bufferViews")) {
    views.push_back(check_view(view, buffers));
  }
  const std::set<std::uint64_t> compressed = find_compressed_indices(root);
  std::uint64_t index = 0;
  for (const JsonView& accessor : root.items("accessors")) {
    check_accessor(accessor, views, compressed.count(index) > 0 ? k_max_compressed : k_max_zeros);
    ++index;
  }
}

}  // namespace lume::io::gltf
