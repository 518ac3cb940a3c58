// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/resources.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace lume::io::gltf {
namespace {

namespace fs = std::filesystem;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') {
    return c - '0';
  }
  if (c >= 'a' && c <= 'f') {
    return c - 'a' + 10;
  }
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// The value of each base64 character; -1 for all others.
constexpr std::array<int, 256> make_base64_values() {
  std::array<int, 256> values{};
  values.fill(-1);
  int next = 0;
  for (const char c : std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                       "0123456789+/")) {
    values[static_cast<unsigned char>(c)] = next++;
  }
  return values;
}
constexpr std::array<int, 256> k_base64_values = make_base64_values();

/// Whether the URI begins with a scheme (RFC 3986, section 3.1).
bool has_scheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  const std::string_view scheme = uri.substr(0, colon);
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_allowed = [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
  };
  return colon != std::string_view::npos && !scheme.empty() && is_letter(scheme.front()) &&
         std::all_of(scheme.begin(), scheme.end(), is_allowed);
}

std::vector<std::byte> decode_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) {
    throw std::runtime_error("is a data URI without a comma");
  }
  const std::string_view data = uri.substr(comma + 1);
  if (uri.substr(0, comma).ends_with(";base64")) {
    return base64_decode(data);
  }
  const std::string text = percent_decode(data);
  std::vector<std::byte> result(text.size());
  std::transform(text.begin(), text.end(), result.begin(),
                 [](char c) { return static_cast<std::byte>(c); });
  return result;
}

/// The file's real place, which must lie in the folder's real place or below.
fs::path contained_path(const std::string& name, const fs::path& folder) {
  const fs::path relative(name);
  if (name.empty() || name.find('\0') != std::string::npos || relative.is_absolute()) {
    throw std::runtime_error("is not a relative path");
  }
  std::error_code error;
  const fs::path base = fs::canonical(folder, error);
  fs::path target = error ? fs::path() : fs::weakly_canonical(base / relative, error);
  if (error) {
    throw std::runtime_error(fmt::format("names '{}': {}", name, error.message()));
  }
  const auto [in_base, in_target] =
      std::mismatch(base.begin(), base.end(), target.begin(), target.end());
  if (in_base != base.end() || in_target == target.end()) {
    throw std::runtime_error(
        fmt::format("names '{}', which is outside the folder of the glTF file", name));
  }
  return target;
}

}  // namespace

std::vector<std::byte> read_whole_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    throw std::runtime_error(error && error != std::errc::no_such_file_or_directory
                                 ? "cannot be read: " + error.message()
                                 : "does not exist");
  }
  if (!fs::is_regular_file(status)) {
    throw std::runtime_error(fs::is_directory(status) ? "is a folder, expected a file"
                                                      : "is not a regular file");
  }
  const std::uintmax_t size = fs::file_size(path, error);
  if (error || size > k_max_file_size) {
    throw std::runtime_error(error ? "cannot be read: " + error.message()
                                   : "is larger than 4 GiB, the most that is read");
  }
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!stream) {
    throw std::runtime_error("cannot be read");
  }
  return bytes;
}

std::string percent_decode(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int high = text[i] == '%' && i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
    const int low = high >= 0 ? hex_digit(text[i + 2]) : -1;
    if (low >= 0) {
      result += static_cast<char>(high * 16 + low);
      i += 2;
    } else {
      result += text[i];
    }
  }
  return result;
}

std::vector<std::byte> base64_decode(std::string_view text) {
  for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) {
    text.remove_suffix(1);
  }
  if (text.size() % 4 == 1) {
    throw std::runtime_error("is a data URI whose base64 text is cut short");
  }
  std::vector<std::byte> result;
  result.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int value = k_base64_values[static_cast<unsigned char>(text[i])];
    if (value < 0) {
      throw std::runtime_error(
          fmt::format("is a data URI with a character that is not base64 (number {})", i));
    }
    bits = (bits << 6) | static_cast<std::uint32_t>(value);
    count += 6;
    if (count >= 8) {
      count -= 8;
      result.push_back(static_cast<std::byte>((bits >> count) & 0xFFu));
    }
  }
  return result;
}

std::vector<std::byte> load_uri(const JsonView& uri, const fs::path& folder) {
  const std::string& text = uri.text();
  try {
    if (text.starts_with("data:")) {
      return decode_data_uri(text);
    }
    if (has_scheme(text)) {
      throw std::runtime_error("expected a relative path or a data URI, not another scheme");
    }
    const std::string name = percent_decode(text);
    const fs::path path = contained_path(name, folder);
    try {
      return read_whole_file(path);
    } catch (const std::runtime_error& reason) {
      throw std::runtime_error(fmt::format("names '{}', which {}", name, reason.what()));
    }
  } catch (const std::runtime_error& reason) {
    uri.fail(reason.what());
  }
}

}  // namespace lume::io::gltf
