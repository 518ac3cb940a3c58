// SPDX-License-Identifier: Apache-2.0
#include "io/error.h"
#include "io/image_io.h"
#include "io/nearest_name.h"
#include "io/picture_formats.h"
#include "io/write_whole_file.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace lume::io {
namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

constexpr std::array k_linear_extensions = {".exr"sv, ".hdr"sv, ".pfm"sv};

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw Error(ErrorKind::input_output, path.string(), "", reason);
}

std::string extension_of(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

std::vector<std::string> known_extensions() {
  std::vector<std::string> known;
  for (const std::string_view extension : scene_linear_extensions()) known.emplace_back(extension);
  for (const std::string_view extension : display_extensions()) known.emplace_back(extension);
  return known;
}

void check_extension(const fs::path& path) {
  const std::vector<std::string> known = known_extensions();
  const std::string extension = extension_of(path);
  if (std::find(known.begin(), known.end(), extension) != known.end()) return;
  fail(path, (extension.empty() ? "a picture's file needs an extension"
                                : "'" + extension + "' is not a format that can be written") +
                 list_names(extension, known));
}

/// The caller filled the picture, so these are mistakes of the program and not of a file.
void check_sizes(const Picture& picture) {
  const PixelRegion& region = picture.region;
  if (region.width <= 0 || region.height <= 0) {
    throw std::invalid_argument("write_picture: an empty region");
  }
  const std::size_t pixels =
      static_cast<std::size_t>(region.width) * static_cast<std::size_t>(region.height);
  const bool layers_fit = std::all_of(
      picture.layers.begin(), picture.layers.end(),
      [&](const Layer& layer) { return layer.pixels.size() == pixels * layer.channels.size(); });
  if (picture.pixels.size() != pixels || !layers_fit) {
    throw std::invalid_argument("write_picture: the pixels do not fill the region");
  }
}

Bytes encode_picture(const Picture& picture, const WriteOptions& options,
                     const std::string& extension, const std::string& name) {
  if (extension == ".exr") return encode_exr(picture, options, name);
  if (extension == ".hdr") return encode_hdr(picture, name);
  if (extension == ".pfm") return encode_pfm(picture);
  return encode_display(picture, options, extension, name);
}

}  // namespace

std::span<const std::string_view> scene_linear_extensions() { return k_linear_extensions; }

void check_writable(const fs::path& path) {
  check_extension(path);
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_regular_file(path, error)) {
    fail(path, "exists and is not a regular file");
  }
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (!fs::is_directory(folder, error)) fail(path, "there is no folder " + folder.string());
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    fail(path, "the folder " + folder.string() + " cannot be written to");
  }
}

void write_picture(const fs::path& path, const Picture& picture, const WriteOptions& options) {
  check_sizes(picture);
  check_writable(path);
  const Bytes bytes = encode_picture(picture, options, extension_of(path), path.string());
  write_whole_file(path, std::as_bytes(std::span(bytes)));
}

}  // namespace lume::io
