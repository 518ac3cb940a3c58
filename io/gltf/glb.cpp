// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/glb.h"

#include "io/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

namespace lume::io::gltf {
namespace {

constexpr std::uint32_t k_magic = 0x46546C67;         // "glTF"
constexpr std::uint32_t k_json_chunk = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t k_binary_chunk = 0x004E4942;  // "BIN"
constexpr std::size_t k_header_size = 12;
constexpr std::size_t k_chunk_header_size = 8;
constexpr int k_max_depth = 64;

/// Little-endian, as the container is on every machine.
std::uint32_t read_u32(Bytes bytes, std::size_t offset) {
  std::uint32_t result = 0;
  for (std::size_t i = 4; i-- > 0;) {
    result = (result << 8) | std::to_integer<std::uint32_t>(bytes[offset + i]);
  }
  return result;
}

struct Chunk {
  std::uint32_t type = 0;
  Bytes data;
  std::size_t next = 0;  ///< where the chunk after it begins
};

Chunk read_chunk(Bytes file, std::size_t offset, const std::string& path) {
  if (file.size() - offset < k_chunk_header_size) {
    throw Error(ErrorKind::scene, path, "",
                fmt::format("the GLB ends inside the chunk header at byte {}", offset));
  }
  const std::size_t length = read_u32(file, offset);
  const std::size_t start = offset + k_chunk_header_size;
  if (length > file.size() - start) {
    throw Error(ErrorKind::scene, path, "",
                fmt::format("the GLB chunk at byte {} claims {} bytes, but only {} follow", offset,
                            length, file.size() - start));
  }
  // Chunks end on multiples of four bytes; writers that forget the last padding do exist.
  const std::size_t next = std::min(file.size(), start + (length + 3) / 4 * 4);
  return {read_u32(file, offset + 4), file.subspan(start, length), next};
}

Chunks split_glb(Bytes file, const std::string& path) {
  if (file.size() < k_header_size) {
    throw Error(ErrorKind::scene, path, "", "the file ends inside the GLB header");
  }
  const std::uint32_t version = read_u32(file, 4);
  if (version != 2) {
    throw Error(ErrorKind::scene, path, "",
                fmt::format("is GLB version {}, expected version 2", version));
  }
  const std::size_t length = read_u32(file, 8);
  if (length > file.size()) {
    throw Error(
        ErrorKind::scene, path, "",
        fmt::format("the GLB header claims {} bytes, but the file has {}", length, file.size()));
  }
  const Bytes content = file.first(std::max(length, k_header_size));
  const Chunk json = read_chunk(content, k_header_size, path);
  if (json.type != k_json_chunk) {
    throw Error(ErrorKind::scene, path, "", "the first GLB chunk is not JSON, as it must be");
  }
  Chunks result{json.data, std::nullopt};
  for (std::size_t next = json.next; next < content.size();) {
    const Chunk chunk = read_chunk(content, next, path);
    if (chunk.type == k_json_chunk || (chunk.type == k_binary_chunk && result.binary)) {
      throw Error(
          ErrorKind::scene, path, "",
          fmt::format("the GLB chunk at byte {} is the second of its type, expected one", next));
    }
    if (chunk.type == k_binary_chunk && next == json.next) {
      result.binary = chunk.data;
    }
    next = chunk.next;
  }
  return result;
}

/// How deep objects and arrays nest, strings left aside. Stops counting at the limit.
bool nests_too_deep(std::string_view text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') {
        ++i;
      } else if (c == '"') {
        in_string = false;
      }
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > k_max_depth) {
        return true;
      }
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return false;
}

std::string line_and_column(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const std::size_t last_break = before.rfind('\n');
  const std::size_t column =
      last_break == std::string_view::npos ? before.size() : before.size() - last_break - 1;
  return fmt::format("line {}, column {}", lines + 1, column);
}

/// 24.0 is an integer to JSON Schema, and so to glTF, but not to parsers.
void store_whole_numbers_as_integers(Json& value) {
  constexpr double k_exact = 9007199254740992.0;  // 2^53, up to which every integer is a double
  if (value.is_number_float()) {
    const auto number = value.get<double>();
    if (number >= 0.0 && number <= k_exact && number == std::floor(number)) {
      value = static_cast<std::uint64_t>(number);
    }
  } else if (value.is_structured()) {
    for (Json& item : value) {
      store_whole_numbers_as_integers(item);
    }
  }
}

}  // namespace

Chunks split_file(Bytes file, const std::string& path) {
  if (file.size() >= 4 && read_u32(file, 0) == k_magic) {
    return split_glb(file, path);
  }
  return {file, std::nullopt};
}

Json parse_json(Bytes bytes, const std::string& path) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (nests_too_deep(text)) {
    throw Error(ErrorKind::scene, path, "",
                fmt::format("the JSON nests deeper than {} levels", k_max_depth));
  }
  try {
    Json result = Json::parse(text.begin(), text.end());
    store_whole_numbers_as_integers(result);
    return result;
  } catch (const Json::parse_error& error) {
    throw Error(
        ErrorKind::scene, path, "",
        "is neither glTF JSON nor GLB: JSON syntax error in " + line_and_column(text, error.byte));
  } catch (const Json::exception&) {
    throw Error(ErrorKind::scene, path, "", "the JSON holds a number that no double can hold");
  }
}

}  // namespace lume::io::gltf
