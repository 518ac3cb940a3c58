// SPDX-License-Identifier: Apache-2.0
#include "io/image_io.h"
#include "renderer/cli/color_map.h"
#include "renderer/cli/compare_report.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lume::cli {
namespace {

io::Picture picture_of(int width, int height) {
  io::Picture picture;
  picture.full_width = width;
  picture.full_height = height;
  picture.region = {0, 0, width, height};
  picture.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return picture;
}

/// The signed difference as the picture's colour, and FLIP as a layer.
io::Picture values(const std::vector<shading::Color>& difference, const std::vector<float>& flip,
                   int width, int height) {
  io::Picture picture = picture_of(width, height);
  std::transform(difference.begin(), difference.end(), picture.pixels.begin(),
                 [](const shading::Color& color) { return shading::Vec4(color, 1.0f); });
  picture.layers.push_back({{"flip.Y"}, flip, true});
  return picture;
}

/// The absolute difference, as bright as its largest value allows, beside the map of FLIP.
io::Picture drawing(const std::vector<shading::Color>& difference, const std::vector<float>& flip,
                    int width, int height) {
  float largest = 0.0f;
  for (const shading::Color& color : difference) {
    largest = std::max(largest, shading::max_component(abs(color)));
  }
  const float scale = largest > 0.0f ? 1.0f / largest : 0.0f;
  io::Picture picture = picture_of(2 * width, height);
  for (std::size_t i = 0; i < difference.size(); ++i) {
    const auto columns = static_cast<std::size_t>(width);
    const std::size_t left = i / columns * 2 * columns + i % columns;
    picture.pixels[left] = shading::Vec4(abs(difference[i]) * scale, 1.0f);
    picture.pixels[left + columns] = shading::Vec4(sequential_color(flip[i]), 1.0f);
  }
  return picture;
}

}  // namespace

void write_difference(const std::string& file, const CompareDocument& document) {
  const io::Comparison& comparison = document.comparison;
  const io::RgbImage actual = io::color_of(document.actual.images[comparison.color_image]);
  const io::RgbImage expected = io::color_of(document.expected.images[comparison.color_image]);
  std::vector<shading::Color> difference(actual.pixels.size());
  for (std::size_t i = 0; i < difference.size(); ++i) {
    difference[i] = actual.pixels[i] - expected.pixels[i];
  }
  io::WriteOptions write;
  write.full_float = true;
  const std::string extension = std::filesystem::path(file).extension().string();
  const auto linear = io::scene_linear_extensions();
  if (std::find(linear.begin(), linear.end(), extension) != linear.end()) {
    io::write_picture(file, values(difference, comparison.flip_map, actual.width, actual.height),
                      write);
    return;
  }
  write.view = io::ViewTransform({{}, {}, "Standard"});
  io::write_picture(file, drawing(difference, comparison.flip_map, actual.width, actual.height),
                    write);
}

}  // namespace lume::cli
