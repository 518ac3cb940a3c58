// SPDX-License-Identifier: Apache-2.0
// Images to be compared, made in memory.
#pragma once

#include "io/compare/channel_image.h"
#include "tests/support/random.h"

#include <string>
#include <utility>
#include <vector>

namespace lume::test {

/// Every channel of an image of `width` x `height` has random values in [0, 1).
inline io::ChannelImage random_image(Random& random, int width, int height,
                                     std::vector<std::string> channels) {
  io::ChannelImage image;
  image.full_width = width;
  image.full_height = height;
  image.region = {0, 0, width, height};
  image.channels = std::move(channels);
  image.planes.resize(image.channels.size());
  for (std::vector<float>& plane : image.planes) {
    for (int i = 0; i < width * height; ++i) plane.push_back(random.uniform());
  }
  return image;
}

inline io::ImageFile file_of(std::string path, io::ChannelImage image) {
  return {std::move(path), {std::move(image)}};
}

}  // namespace lume::test
