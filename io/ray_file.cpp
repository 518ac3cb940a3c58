// SPDX-License-Identifier: Apache-2.0
#include "io/ray_file.h"

#include "io/error.h"
#include "io/write_whole_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>
#include <system_error>

namespace lume::io {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "numbers are written as they are");

constexpr std::string_view k_magic = "LUMERAYS";
constexpr std::uint32_t k_version = 1;
constexpr std::uint32_t k_most_lists = 256;
constexpr std::uint32_t k_longest_name = 64;
constexpr std::uint32_t k_any_hit = 1;
constexpr std::uint32_t k_coherent = 2;

/// Origin, t_min, direction, t_max, as they stand in memory.
using RayFloats = std::array<float, 8>;
static_assert(sizeof(geometry::Ray) == sizeof(RayFloats));

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw Error(ErrorKind::input_output, path.string(), "", reason);
}

bool is_name(std::string_view name) {
  const auto is_printable = [](char c) { return c >= ' ' && c <= '~'; };
  return !name.empty() && name.size() <= k_longest_name &&
         std::all_of(name.begin(), name.end(), is_printable);
}

std::vector<std::byte> read_bytes(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    fail(path, fs::exists(path, error) ? "is not a file" : "does not exist");
  }
  std::vector<std::byte> bytes(fs::file_size(path));
  std::ifstream file(path, std::ios::binary);
  // Characters may stand for any bytes.
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file || file.gcount() != static_cast<std::streamsize>(bytes.size())) {
    fail(path, "cannot be read");
  }
  return bytes;
}

/// Walks through a file's bytes.
class Reader {
 public:
  Reader(const fs::path& path, std::span<const std::byte> bytes) : path_(path), bytes_(bytes) {}

  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
  [[noreturn]] void complain(const std::string& reason) const {
    fail(path_, fmt::format("byte {}: {}", at_, reason));
  }

  template <class T>
  T number(std::string_view what) {
    T value{};
    std::memcpy(&value, take(sizeof value, what).data(), sizeof value);
    return value;
  }
  std::string text(std::size_t size, std::string_view what) {
    std::string result(size, '\0');
    std::memcpy(result.data(), take(size, what).data(), size);
    return result;
  }
  std::vector<geometry::Ray> rays(std::uint64_t count);

 private:
  std::span<const std::byte> take(std::size_t size, std::string_view what) {
    if (size > left()) {
      complain(fmt::format("the file ends within {}; expected {} more bytes", what, size - left()));
    }
    at_ += size;
    return bytes_.subspan(at_ - size, size);
  }

  const fs::path& path_;
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

std::vector<geometry::Ray> Reader::rays(std::uint64_t count) {
  if (count > left() / sizeof(RayFloats)) {
    complain(fmt::format("{} rays need {} bytes each, but only {} bytes are left", count,
                         sizeof(RayFloats), left()));
  }
  std::vector<geometry::Ray> result;
  result.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto f = number<RayFloats>("a ray");
    result.push_back({.origin = {f[0], f[1], f[2]},
                      .t_min = f[3],
                      .direction = {f[4], f[5], f[6]},
                      .t_max = f[7]});
    if (is_traceable(result.back())) continue;
    at_ -= sizeof(RayFloats);
    complain(fmt::format("ray {} is not one: expected finite numbers and 0 <= t_min <= t_max", i));
  }
  return result;
}

RayList read_list(Reader& reader) {
  RayList list;
  const auto name_size = reader.number<std::uint32_t>("a name's length");
  if (name_size == 0 || name_size > k_longest_name) {
    reader.complain(
        fmt::format("a name of {} characters; expected 1 to {}", name_size, k_longest_name));
  }
  list.name = reader.text(name_size, "a name");
  if (!is_name(list.name)) reader.complain("a name that is not printable ASCII");
  const auto flags = reader.number<std::uint32_t>("the flags");
  if ((flags & ~(k_any_hit | k_coherent)) != 0) {
    reader.complain(fmt::format("unknown flags {:#x}; expected 1 and 2 only", flags));
  }
  list.any_hit = (flags & k_any_hit) != 0;
  list.coherent = (flags & k_coherent) != 0;
  const auto count = reader.number<std::uint64_t>("the number of rays");
  list.rays = reader.rays(count);
  return list;
}

template <class T>
void append(std::vector<std::byte>& bytes, const T& value) {
  const auto* begin = reinterpret_cast<const std::byte*>(&value);
  bytes.insert(bytes.end(), begin, begin + sizeof value);
}

void append_text(std::vector<std::byte>& bytes, std::string_view text) {
  for (const char c : text) append(bytes, c);
}

}  // namespace

void write_rays(const fs::path& path, const std::vector<RayList>& lists) {
  if (lists.size() > k_most_lists) fail(path, "too many kinds of rays");
  std::vector<std::byte> bytes;
  append_text(bytes, k_magic);
  append(bytes, k_version);
  append(bytes, static_cast<std::uint32_t>(lists.size()));
  for (const RayList& list : lists) {
    if (!is_name(list.name)) fail(path, "a kind of rays needs a name of 1 to 64 ASCII characters");
    append(bytes, static_cast<std::uint32_t>(list.name.size()));
    append_text(bytes, list.name);
    append(bytes, (list.any_hit ? k_any_hit : 0u) | (list.coherent ? k_coherent : 0u));
    append(bytes, static_cast<std::uint64_t>(list.rays.size()));
    for (const geometry::Ray& ray : list.rays) append(bytes, std::bit_cast<RayFloats>(ray));
  }
  write_whole_file(path, bytes);
}

std::vector<RayList> decode_rays(std::span<const std::byte> bytes, const fs::path& path) {
  Reader reader(path, bytes);
  if (reader.left() < k_magic.size() || reader.text(k_magic.size(), "the magic") != k_magic) {
    fail(path, fmt::format("is not a ray file; expected it to begin with {}", k_magic));
  }
  const auto version = reader.number<std::uint32_t>("the version");
  if (version != k_version) {
    reader.complain(fmt::format("version {}; this Lume reads version {}", version, k_version));
  }
  const auto count = reader.number<std::uint32_t>("the number of kinds");
  if (count > k_most_lists) {
    reader.complain(fmt::format("{} kinds of rays; expected at most {}", count, k_most_lists));
  }
  std::vector<RayList> lists;
  lists.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) lists.push_back(read_list(reader));
  if (reader.left() > 0) reader.complain(fmt::format("{} bytes too many", reader.left()));
  return lists;
}

std::vector<RayList> read_rays(const fs::path& path) { return decode_rays(read_bytes(path), path); }

}  // namespace lume::io
