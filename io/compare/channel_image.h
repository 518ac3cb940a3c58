// SPDX-License-Identifier: Apache-2.0
// Images as comparison sees them: by the names of their channels, as they stand in the file.
#pragma once

#include "io/compare/rgb_image.h"
#include "shading/image.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lume::io {

/// One image of a file: a part of an EXR, a page of a TIFF, or all that there is. Integers are
/// normalized to [0, 1]; nothing is converted otherwise.
struct ChannelImage {
  std::string name;    ///< of the part; empty where there is one only
  int full_width = 0;  ///< of the display window
  int full_height = 0;
  shading::PixelRegion region;        ///< the data window, from the corner of the display window
  bool display_referred = false;      ///< integers on file: sRGB; floats are scene-linear
  std::vector<std::string> channels;  ///< "R", "G", "B", "A", "depth.Z" ..., as in the file
  std::vector<std::vector<float>> planes;  ///< of each channel, region.width * region.height values
};

struct ImageFile {
  std::string path;  ///< for messages
  std::vector<ChannelImage> images;
};

/// Reads every channel of every image of a file in any format of OpenImageIO. Throws
/// Error(input_output).
[[nodiscard]] ImageFile read_channels(const std::filesystem::path& path);

/// Whether there is a colour: channels R, G and B, or Y, or nothing but one.
[[nodiscard]] bool has_color(const ChannelImage& image);

/// The image's colour in linear Rec.709: R, G and B, or grey from Y or a single channel; sRGB is
/// decoded, what is missing is 0 and what is not finite as well. Colour is taken as it stands,
/// associated alpha included.
[[nodiscard]] RgbImage color_of(const ChannelImage& image);

}  // namespace lume::io
