// SPDX-License-Identifier: Apache-2.0
// Pictures in and out of files, through OpenImageIO.
#pragma once

#include "io/color.h"
#include "shading/environment.h"
#include "shading/image.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace lume::io {

/// Decodes a PNG, JPEG, WebP ... from memory to four channels with unassociated alpha (grey is
/// repeated, a missing alpha is 1), 8 bit stays 8 bit, 16 stays 16. `name` is for messages.
/// Throws Error(input_output).
[[nodiscard]] shading::Image decode_image(std::span<const std::byte> bytes,
                                          const std::string& name);

/// As decode_image, but reads only the header: the result has its size and no texels.
[[nodiscard]] shading::Image probe_image(std::span<const std::byte> bytes, const std::string& name);

/// Reads an equirectangular environment (.hdr, .exr, or any format of OpenImageIO; integer formats
/// are taken as sRGB). Radiances that are negative or not finite become 0. Throws
/// Error(input_output).
[[nodiscard]] shading::Environment read_environment(const std::filesystem::path& path);

using shading::PixelRegion;

/// One more layer of an EXR: `channels` names its channels as they are to stand in the file ("Z",
/// "N.x" ...), interleaved in `pixels`, row 0 at the top.
struct Layer {
  std::vector<std::string> channels;
  std::vector<float> pixels;
  bool full_precision = false;  ///< 32-bit float on file: depth, positions, identities
};

/// A finished rendering: scene-linear Rec.709 with associated alpha, and what was recorded beside
/// it.
struct Picture {
  int full_width = 0;  ///< of the whole image (EXR display window)
  int full_height = 0;
  PixelRegion region;                           ///< the part that was rendered (EXR data window)
  std::vector<shading::Vec4> pixels;            ///< region.width * region.height, row 0 at the top
  std::vector<Layer> layers;                    ///< written to EXR only
  std::map<std::string, std::string> metadata;  ///< "lume:scene" and so on
  /// Row-major world-to-camera matrix, Imath convention (row vectors); written when set.
  std::vector<float> world_to_camera;
};

struct WriteOptions {
  ViewTransform view;               ///< for display formats
  float exposure = 0.0f;            ///< EV: display formats show radiance * 2^exposure
  bool full_float = false;          ///< 32-bit instead of half EXR beauty
  std::string compression = "zip";  ///< EXR
  int jpeg_quality = 95;
};

/// The extensions write_picture accepts, with the dot, lower case.
[[nodiscard]] std::span<const std::string_view> scene_linear_extensions();  ///< .exr .hdr .pfm
[[nodiscard]] std::span<const std::string_view> display_extensions();       ///< .png .jpg .tif ...

/// Throws Error(input_output) now if write_picture would later refuse the path: an unknown
/// extension (the message lists those possible) or a folder that does not exist or cannot be
/// written.
void check_writable(const std::filesystem::path& path);

/// Writes the picture in the format of the path's extension. The file appears whole or not at all:
/// it is written beside its place and renamed. Throws Error(input_output).
void write_picture(const std::filesystem::path& path, const Picture& picture,
                   const WriteOptions& options);

}  // namespace lume::io
