// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/test_pictures.h"

#include "io/image_io.h"
#include "renderer/cli/color_map.h"

#include <algorithm>

namespace lume::cli {

void write_flip_map(const std::filesystem::path& file, const std::vector<float>& flip_map,
                    int width, int height) {
  io::Picture picture;
  picture.full_width = width;
  picture.full_height = height;
  picture.region = {0, 0, width, height};
  picture.pixels.resize(flip_map.size());
  std::transform(flip_map.begin(), flip_map.end(), picture.pixels.begin(),
                 [](float error) { return shading::Vec4(sequential_color(error), 1.0f); });
  io::WriteOptions write;
  write.view = io::ViewTransform({{}, {}, "Standard"});
  io::write_picture(file, picture, write);
}

}  // namespace lume::cli
