// SPDX-License-Identifier: Apache-2.0
// What the statistical tests look at: one picture, estimated several times, or once with its
// variance. Values are finite; row 0 is the top one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lume::io {

struct PictureShape {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;

  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// Images of one view that differ by their seeds only, so that their spread tells their error.
struct EstimateStack {
  PictureShape shape;
  /// [estimate][channel]: width * height values, as ChannelImage::planes
  std::vector<std::vector<std::vector<float>>> images;
  int samples = 0;  ///< per pixel of each image; 0: not known
};

/// One image together with how far it is to be trusted.
struct EstimateMoments {
  PictureShape shape;
  std::vector<std::vector<float>> mean;      ///< [channel]: width * height values
  std::vector<std::vector<float>> variance;  ///< of that mean, not of one sample
  int samples = 0;  ///< independent ones behind mean and variance; 0: so many that it is no matter
};

}  // namespace lume::io
