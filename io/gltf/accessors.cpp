// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/accessors.h"

#include "io/error.h"
#include "io/gltf/component.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace lume::io::gltf {
namespace {

using geometry::Vec2;
using geometry::Vec3;
using geometry::Vec4;

/// `count` elements of one component type, `stride` bytes apart. They lie in their buffer.
struct Elements {
  const std::byte* data = nullptr;
  std::size_t stride = 0;
  std::size_t count = 0;
  Component component = Component::f32;
  bool normalized = false;
};

/// The number of components of a glm vector.
template <class V>
constexpr int k_components = V::length();

/// Normalized integers: c / (2^n - 1), or max(c / (2^(n-1) - 1), -1) for signed ones (glTF 2.0,
/// section 3.6.2.2).
template <class Stored, bool Normalized>
float to_float(Stored stored) {
  const auto value = static_cast<float>(stored);
  if constexpr (!Normalized || std::is_floating_point_v<Stored>) {
    return value;
  } else {
    constexpr auto k_largest = static_cast<float>(std::numeric_limits<Stored>::max());
    return std::max(value / k_largest, -1.0f);
  }
}

template <class Stored, bool Normalized, class V>
void convert(const Elements& elements, V* out) {
  const std::byte* element = elements.data;
  for (std::size_t i = 0; i < elements.count; ++i, element += elements.stride) {
    Stored stored[k_components<V>];  // copied out: accessors need not be aligned in memory
    std::memcpy(stored, element, sizeof(stored));
    for (int c = 0; c < k_components<V>; ++c) {
      out[i][c] = to_float<Stored, Normalized>(stored[c]);
    }
  }
}

template <bool Normalized, class V>
void convert_any(const Elements& elements, V* out) {
  switch (elements.component) {
    case Component::i8:
      return convert<std::int8_t, Normalized>(elements, out);
    case Component::u8:
      return convert<std::uint8_t, Normalized>(elements, out);
    case Component::i16:
      return convert<std::int16_t, Normalized>(elements, out);
    case Component::u16:
      return convert<std::uint16_t, Normalized>(elements, out);
    case Component::u32:
      return convert<std::uint32_t, Normalized>(elements, out);
    case Component::f32:
      return convert<float, Normalized>(elements, out);
  }
}

template <class V>
void convert_vectors(const Elements& elements, V* out) {
  if (elements.normalized) {
    convert_any<true>(elements, out);
  } else {
    convert_any<false>(elements, out);
  }
}

template <class Stored>
void widen(const Elements& elements, std::uint32_t* out) {
  const std::byte* element = elements.data;
  for (std::size_t i = 0; i < elements.count; ++i, element += elements.stride) {
    Stored stored;
    std::memcpy(&stored, element, sizeof(stored));
    out[i] = stored;
  }
}

std::vector<std::uint32_t> widen_any(const Elements& elements) {
  std::vector<std::uint32_t> result(elements.count);
  if (elements.component == Component::u8) {
    widen<std::uint8_t>(elements, result.data());
  } else if (elements.component == Component::u16) {
    widen<std::uint16_t>(elements, result.data());
  } else {
    widen<std::uint32_t>(elements, result.data());
  }
  return result;
}

/// Packed elements within a buffer view.
Elements packed(const Document& document, int view, std::size_t offset, std::size_t count,
                Component component, std::size_t components) {
  const std::size_t size = components * component_size(static_cast<std::uint64_t>(component));
  const Bytes bytes = document.view_bytes(static_cast<std::size_t>(view));
  return {bytes.data() + offset, size, count, component, false};
}

Elements elements_of(const Document& document, const tinygltf::Accessor& accessor,
                     std::size_t components) {
  Elements result = packed(document, accessor.bufferView, accessor.byteOffset, accessor.count,
                           static_cast<Component>(accessor.componentType), components);
  result.normalized = accessor.normalized;
  const auto view = static_cast<std::size_t>(accessor.bufferView);
  if (const std::size_t stride = document.model.bufferViews[view].byteStride; stride != 0) {
    result.stride = stride;
  }
  return result;
}

std::vector<std::uint32_t> sparse_indices(const Document& document, std::size_t accessor_index) {
  const tinygltf::Accessor& accessor = document.model.accessors[accessor_index];
  const auto& sparse = accessor.sparse;
  const auto count = static_cast<std::size_t>(sparse.count);
  std::vector<std::uint32_t> indices = widen_any(packed(
      document, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
      count, static_cast<Component>(sparse.indices.componentType), 1));
  for (std::size_t i = 0; i < count; ++i) {
    if (indices[i] >= accessor.count) {
      throw Error(ErrorKind::scene, document.file,
                  fmt::format("/accessors/{}/sparse/indices", accessor_index),
                  fmt::format("sparse index {} is {}, expected one below {}", i, indices[i],
                              accessor.count));
    }
  }
  return indices;
}

template <class V>
std::vector<V> read_vectors(const Document& document, std::size_t accessor_index) {
  constexpr auto k_width = static_cast<std::size_t>(k_components<V>);
  const tinygltf::Accessor& accessor = document.model.accessors[accessor_index];
  std::vector<V> result(accessor.count, V(0.0f));
  if (accessor.bufferView >= 0) {
    convert_vectors(elements_of(document, accessor, k_width), result.data());
  }
  if (accessor.sparse.isSparse) {
    const std::vector<std::uint32_t> indices = sparse_indices(document, accessor_index);
    Elements replacements =
        packed(document, accessor.sparse.values.bufferView,
               static_cast<std::size_t>(accessor.sparse.values.byteOffset), indices.size(),
               static_cast<Component>(accessor.componentType), k_width);
    replacements.normalized = accessor.normalized;
    std::vector<V> values(indices.size());
    convert_vectors(replacements, values.data());
    for (std::size_t i = 0; i < indices.size(); ++i) {
      result[indices[i]] = values[i];
    }
  }
  return result;
}

template <class Stored>
void append_numbers(const Elements& elements, std::size_t width, std::vector<double>& out) {
  constexpr auto k_largest = static_cast<double>(std::numeric_limits<Stored>::max());
  const bool is_fraction = elements.normalized && std::is_integral_v<Stored>;
  for (std::size_t i = 0; i < elements.count; ++i) {
    for (std::size_t c = 0; c < width; ++c) {
      Stored stored;
      std::memcpy(&stored, elements.data + i * elements.stride + c * sizeof(stored),
                  sizeof(stored));
      const auto value = static_cast<double>(stored);
      out.push_back(is_fraction ? std::max(value / k_largest, -1.0) : value);
    }
  }
}

std::vector<double> numbers_of(const Elements& elements, std::size_t width) {
  std::vector<double> result;
  result.reserve(elements.count * width);
  switch (elements.component) {
    case Component::i8:
      append_numbers<std::int8_t>(elements, width, result);
      break;
    case Component::u8:
      append_numbers<std::uint8_t>(elements, width, result);
      break;
    case Component::i16:
      append_numbers<std::int16_t>(elements, width, result);
      break;
    case Component::u16:
      append_numbers<std::uint16_t>(elements, width, result);
      break;
    case Component::u32:
      append_numbers<std::uint32_t>(elements, width, result);
      break;
    case Component::f32:
      append_numbers<float>(elements, width, result);
      break;
  }
  return result;
}

}  // namespace

std::vector<double> read_numbers(const Document& document, std::size_t accessor_index) {
  const tinygltf::Accessor& accessor = document.model.accessors[accessor_index];
  const auto width = static_cast<std::size_t>(
      tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
  std::vector<double> result(accessor.count * width, 0.0);
  if (accessor.bufferView >= 0) {
    result = numbers_of(elements_of(document, accessor, width), width);
  }
  if (accessor.sparse.isSparse) {
    const std::vector<std::uint32_t> places = sparse_indices(document, accessor_index);
    Elements elements =
        packed(document, accessor.sparse.values.bufferView,
               static_cast<std::size_t>(accessor.sparse.values.byteOffset), places.size(),
               static_cast<Component>(accessor.componentType), width);
    elements.normalized = accessor.normalized;
    const std::vector<double> values = numbers_of(elements, width);
    for (std::size_t i = 0; i < values.size(); ++i) {
      result[places[i / width] * width + i % width] = values[i];
    }
  }
  return result;
}

std::vector<Vec2> read_vec2(const Document& document, std::size_t accessor) {
  return read_vectors<Vec2>(document, accessor);
}

std::vector<Vec3> read_vec3(const Document& document, std::size_t accessor) {
  return read_vectors<Vec3>(document, accessor);
}

std::vector<Vec4> read_vec4(const Document& document, std::size_t accessor) {
  return read_vectors<Vec4>(document, accessor);
}

std::vector<std::uint32_t> read_indices(const Document& document, std::size_t accessor_index) {
  const tinygltf::Accessor& accessor = document.model.accessors[accessor_index];
  std::vector<std::uint32_t> result = widen_any(elements_of(document, accessor, 1));
  if (accessor.sparse.isSparse) {
    const std::vector<std::uint32_t> places = sparse_indices(document, accessor_index);
    const std::vector<std::uint32_t> values =
        widen_any(packed(document, accessor.sparse.values.bufferView,
                         static_cast<std::size_t>(accessor.sparse.values.byteOffset), places.size(),
                         static_cast<Component>(accessor.componentType), 1));
    for (std::size_t i = 0; i < places.size(); ++i) {
      result[places[i]] = values[i];
    }
  }
  return result;
}

}  // namespace lume::io::gltf
