// SPDX-License-Identifier: Apache-2.0
#include "io/report/reduced_image.h"

#include <algorithm>

namespace lume::io {
namespace {

constexpr int divide_up(int value, int by) { return value / by + (value % by != 0 ? 1 : 0); }

std::size_t index(int x, int y, int width) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(x);
}

template <class Value>
std::vector<Value> means_of_squares(std::span<const Value> values, int width, int height,
                                    int factor) {
  const int columns = divide_up(width, factor);
  const int rows = divide_up(height, factor);
  std::vector<Value> means;
  means.reserve(index(0, rows, columns));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int right = std::min((column + 1) * factor, width);
      const int bottom = std::min((row + 1) * factor, height);
      Value sum(0.0f);
      for (int y = row * factor; y < bottom; ++y) {
        for (int x = column * factor; x < right; ++x) sum += values[index(x, y, width)];
      }
      const int count = (right - column * factor) * (bottom - row * factor);
      means.push_back(sum / static_cast<float>(count));
    }
  }
  return means;
}

}  // namespace

int reduction_factor(int width, int height, const SizeLimit& limit) {
  int factor = 1;
  const auto fits = [&] {
    const int columns = divide_up(width, factor);
    const int rows = divide_up(height, factor);
    return std::max(columns, rows) <= limit.side && index(0, rows, columns) <= limit.pixels;
  };
  while (!fits()) ++factor;
  return factor;
}

RgbImage reduce(const RgbImage& image, int factor) {
  const std::span<const shading::Color> pixels = image.pixels;
  return {divide_up(image.width, factor), divide_up(image.height, factor),
          means_of_squares(pixels, image.width, image.height, factor)};
}

std::vector<float> reduce(std::span<const float> values, int width, int height, int factor) {
  return means_of_squares(values, width, height, factor);
}

}  // namespace lume::io
