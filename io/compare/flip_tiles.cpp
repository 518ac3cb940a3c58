// SPDX-License-Identifier: Apache-2.0
#include "io/compare/flip_tiles.h"

#include "geometry/parallel.h"
#include "io/compare/flip_color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace lume::io {
namespace {

// Large enough to make little of the margins, small enough for the cache.
constexpr std::size_t k_tile_width = 256;
constexpr std::size_t k_tile_height = 96;

// The curve as (a x^2 + b x) / (c x^2 + d x + e), by Narkowicz's letters.
constexpr double k_aces_exposure = 0.6;
constexpr double k_a = 2.51 * k_aces_exposure * k_aces_exposure;
constexpr double k_b = 0.03 * k_aces_exposure;
constexpr double k_c = 2.43 * k_aces_exposure * k_aces_exposure;
constexpr double k_d = 0.59 * k_aces_exposure;
constexpr double k_e = 0.14;
/// Where the curve is well above 1, so that no square is too large for a double.
constexpr double k_white = 64.0;

double shown(float linear, const FlipDisplay& display) {
  const double value = display.exposure * static_cast<double>(linear);
  if (!(value > 0.0)) return 0.0;  // also what is not a number
  return std::min(display.tone_mapped ? tone_map_aces(std::min(value, k_white)) : value, 1.0);
}

struct Tile {
  std::size_t x = 0;
  std::size_t y = 0;
  std::size_t width = 0;
  std::size_t height = 0;
};

/// A picture as the eye gets it.
struct Percept {
  std::array<Plane, 3> lab;
  Plane edge;   ///< how much of an edge there is
  Plane point;  ///< how much of a point
};

/// Turns tiles of a picture into percepts; keeps its memory from one to the next.
class Eye {
 public:
  Eye(const FlipDisplay& display, const FlipKernels& kernels)
      : display_(display), kernels_(kernels) {}

  void look(const RgbImage& image, const Tile& tile, Percept& percept) {
    load(image, tile);
    see_color(percept.lab);
    filter_across(opponent_[0], kernels_.smooth, kernels_.radius, smooth_);
    see_features(kernels_.edge, percept.edge);
    see_features(kernels_.point, percept.point);
  }

 private:
  /// The tile with a margin, which beyond the border has the pixels of the picture's edge.
  void load(const RgbImage& image, const Tile& tile) {
    const std::size_t margin = kernels_.radius;
    for (Plane& plane : opponent_) {
      plane.resize(tile.width + 2 * margin, tile.height + 2 * margin);
    }
    const auto inside = [margin](std::size_t i, int size) {
      const std::size_t last = static_cast<std::size_t>(size) - 1;
      return i < margin ? 0 : std::min(i - margin, last);
    };
    for (std::size_t y = 0; y < opponent_[0].height; ++y) {
      const shading::Color* row = image.pixels.data() + inside(tile.y + y, image.height) *
                                                            static_cast<std::size_t>(image.width);
      for (std::size_t x = 0; x < opponent_[0].width; ++x) {
        const shading::Color& pixel = row[inside(tile.x + x, image.width)];
        const Triple color = to_opponent(
            {shown(pixel.x, display_), shown(pixel.y, display_), shown(pixel.z, display_)});
        for (std::size_t c = 0; c < 3; ++c) opponent_[c].row(y)[x] = color[c];
      }
    }
  }

  void filter(const Plane& in, const SeparableKernel& kernel, Plane& out) {
    filter_across(in, kernel.across, kernels_.radius, across_);
    filter_down(across_, kernel.down, kernels_.radius, out);
  }

  void see_color(std::array<Plane, 3>& lab) {
    filter(opponent_[0], kernels_.achromatic, lab[0]);
    filter(opponent_[1], kernels_.red_green, lab[1]);
    filter(opponent_[2], kernels_.blue_yellow_wide, lab[2]);
    filter(opponent_[2], kernels_.blue_yellow_narrow, filtered_);
    for (std::size_t i = 0; i < filtered_.values.size(); ++i) {
      const double blue_yellow = lab[2].values[i] + filtered_.values[i];
      const Triple color = to_hunt_lab({lab[0].values[i], lab[1].values[i], blue_yellow});
      for (std::size_t c = 0; c < 3; ++c) lab[c].values[i] = color[c];
    }
  }

  /// The length of the detector's answers along x and along y.
  void see_features(const Kernel& detector, Plane& length) {
    filter(opponent_[0], {detector, kernels_.smooth}, length);
    filter_down(smooth_, detector, kernels_.radius, filtered_);
    for (std::size_t i = 0; i < length.values.size(); ++i) {
      const double x = length.values[i];
      const double y = filtered_.values[i];
      length.values[i] = std::sqrt(x * x + y * y);
    }
  }

  const FlipDisplay display_;
  const FlipKernels& kernels_;
  std::array<Plane, 3> opponent_;
  Plane across_;
  Plane smooth_;
  Plane filtered_;
};

/// The greater of both differences, to the power q_f = 1/2.
double feature_error(double edge, double point) {
  return std::sqrt(std::max(std::abs(edge), std::abs(point)) / std::numbers::sqrt2);
}

double error_of(const Percept& a, const Percept& b, std::size_t i) {
  const auto color = [i](const Percept& percept) {
    return Triple{percept.lab[0].values[i], percept.lab[1].values[i], percept.lab[2].values[i]};
  };
  return combined_error(
      color_error(color(a), color(b)),
      feature_error(a.edge.values[i] - b.edge.values[i], a.point.values[i] - b.point.values[i]));
}

/// Whether the eye gets the same of both pictures in a tile, as in most of one that hardly changed.
bool are_alike(const RgbImage& a, const RgbImage& b, const Tile& tile, std::size_t margin) {
  const auto width = static_cast<std::size_t>(a.width);
  const auto first = [margin](std::size_t at) {
    return static_cast<std::ptrdiff_t>(at - std::min(at, margin));
  };
  const auto left = first(tile.x);
  const auto right = static_cast<std::ptrdiff_t>(std::min(tile.x + tile.width + margin, width));
  const auto bottom = static_cast<std::ptrdiff_t>(
      std::min(tile.y + tile.height + margin, static_cast<std::size_t>(a.height)));
  for (auto y = first(tile.y); y < bottom; ++y) {
    const auto row = y * static_cast<std::ptrdiff_t>(width);
    const auto begin = a.pixels.begin() + row;
    if (!std::equal(begin + left, begin + right, b.pixels.begin() + row + left)) return false;
  }
  return true;
}

}  // namespace

double tone_map_aces(double x) { return (k_a * x + k_b) * x / ((k_c * x + k_d) * x + k_e); }

double inverse_tone_map_aces(double y) {
  // (a - c y) x^2 + (b - d y) x - e y = 0
  const double square = k_a - k_c * y;
  const double linear = k_b - k_d * y;
  return (-linear + std::sqrt(linear * linear + 4.0 * square * k_e * y)) / (2.0 * square);
}

std::vector<float> flip_map(const RgbImage& reference, const RgbImage& test,
                            const FlipDisplay& display, const FlipKernels& kernels) {
  const auto width = static_cast<std::size_t>(reference.width);
  const auto height = static_cast<std::size_t>(reference.height);
  std::vector<float> errors(width * height);
  const std::size_t columns = (width + k_tile_width - 1) / k_tile_width;
  const std::size_t rows = (height + k_tile_height - 1) / k_tile_height;
  geometry::parallel_for(columns * rows, [&](std::size_t index) {
    Tile tile{index % columns * k_tile_width, index / columns * k_tile_height, 0, 0};
    tile.width = std::min(width - tile.x, k_tile_width);
    tile.height = std::min(height - tile.y, k_tile_height);
    if (are_alike(reference, test, tile, kernels.radius)) return;
    Eye eye(display, kernels);
    std::array<Percept, 2> percepts;
    eye.look(reference, tile, percepts[0]);
    eye.look(test, tile, percepts[1]);
    for (std::size_t i = 0; i < tile.width * tile.height; ++i) {
      const std::size_t at = (tile.y + i / tile.width) * width + tile.x + i % tile.width;
      errors[at] = static_cast<float>(error_of(percepts[0], percepts[1], i));
    }
  });
  return errors;
}

void check_flip(const RgbImage& reference, const RgbImage& test, const FlipOptions& options) {
  if (reference.width != test.width || reference.height != test.height) {
    throw std::invalid_argument("FLIP: pictures must be of one size");
  }
  // Also refuses what is not a number.
  if (!(options.pixels_per_degree >= k_flip_least_pixels_per_degree &&
        options.pixels_per_degree <= k_flip_most_pixels_per_degree)) {
    throw std::invalid_argument("FLIP: pixels per degree must be between 1 and 1000");
  }
}

}  // namespace lume::io
