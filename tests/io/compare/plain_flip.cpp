// SPDX-License-Identifier: Apache-2.0
#include "tests/io/compare/plain_flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace lume::tests {
namespace {

using Rgb = std::array<double, 3>;

/// Values of a picture that goes on with its edge.
struct Channel {
  int width = 0;
  int height = 0;
  std::vector<double> values;

  [[nodiscard]] double at(int x, int y) const {
    const int inside_x = std::clamp(x, 0, width - 1);
    const int inside_y = std::clamp(y, 0, height - 1);
    return values[static_cast<std::size_t>(inside_y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(inside_x)];
  }
};

constexpr double k_pi = 3.141592653589793;
// White in XYZ, as the sums of the matrix's rows.
constexpr double k_white_x = 23359437.0 / 24577794.0;
constexpr double k_white_z = 80288307.0 / 73733382.0;

double square(double x) { return x * x; }

Rgb xyz_from_linear(const Rgb& c) {
  return {(10135552 * c[0] + 8788810 * c[1] + 4435075 * c[2]) / 24577794,
          (2613072 * c[0] + 8788810 * c[1] + 887015 * c[2]) / 12288897,
          (1425312 * c[0] + 8788810 * c[1] + 70074185 * c[2]) / 73733382};
}

/// The inverse as it is published, in nine digits.
Rgb linear_from_xyz(const Rgb& c) {
  return {3.241003275 * c[0] - 1.537398934 * c[1] - 0.498615861 * c[2],
          -0.969224334 * c[0] + 1.875930071 * c[1] + 0.041554224 * c[2],
          0.055639423 * c[0] - 0.204011202 * c[1] + 1.057148933 * c[2]};
}

Rgb ycxcz_from_linear(const Rgb& linear) {
  const Rgb c = xyz_from_linear(linear);
  return {116 * c[1] - 16, 500 * (c[0] / k_white_x - c[1]), 200 * (c[1] - c[2] / k_white_z)};
}

Rgb linear_from_ycxcz(const Rgb& c) {
  const double y = (c[0] + 16) / 116;
  return linear_from_xyz({(c[1] / 500 + y) * k_white_x, y, (y - c[2] / 200) * k_white_z});
}

Rgb hunt_lab_from_linear(const Rgb& linear) {
  const auto f = [](double t) {
    return t > std::pow(6.0 / 29.0, 3) ? std::pow(t, 1.0 / 3.0)
                                       : t * square(29.0 / 6.0) / 3.0 + 4.0 / 29.0;
  };
  const Rgb c = xyz_from_linear(linear);
  const double x = f(c[0] / k_white_x);
  const double y = f(c[1]);
  const double z = f(c[2] / k_white_z);
  const double l = 116 * y - 16;
  return {l, 0.01 * l * 500 * (x - y), 0.01 * l * 200 * (y - z)};
}

double hyab(const Rgb& a, const Rgb& b) {
  return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

/// A square of weights.
struct Filter {
  int radius = 0;
  std::vector<double> weights;

  Filter(int r, const std::function<double(int x, int y)>& weight) : radius(r) {
    for (int y = -r; y <= r; ++y) {
      for (int x = -r; x <= r; ++x) weights.push_back(weight(x, y));
    }
  }

  [[nodiscard]] double apply(const Channel& channel, int x, int y) const {
    double sum = 0.0;
    const double* weight = weights.data();
    for (int dy = -radius; dy <= radius; ++dy) {
      for (int dx = -radius; dx <= radius; ++dx) sum += *weight++ * channel.at(x + dx, y + dy);
    }
    return sum;
  }

  /// Positive weights to a sum of 1, negative ones to -1.
  Filter& normalize() {
    double positive = 0.0;
    double negative = 0.0;
    for (const double weight : weights) (weight > 0.0 ? positive : negative) += weight;
    for (double& weight : weights) weight /= weight > 0.0 ? positive : -negative;
    return *this;
  }
};

Filter sensitivity(double a1, double b1, double a2, double b2, double pixels_per_degree) {
  const int radius =
      static_cast<int>(std::ceil(3 * std::sqrt(0.04 / 2) / k_pi * pixels_per_degree));
  const auto gauss = [](double a, double b, double d2) {
    return a * std::sqrt(k_pi / b) * std::exp(-square(k_pi) * d2 / b);
  };
  Filter filter(radius, [&](int x, int y) {
    const double d2 = (x * x + y * y) / square(pixels_per_degree);
    return gauss(a1, b1, d2) + gauss(a2, b2, d2);
  });
  return filter.normalize();
}

/// Of derivatives of a Gaussian along x (transposed: along y) of the first or second order.
Filter detector(int order, bool transposed, double pixels_per_degree) {
  const double s = 0.5 * 0.082 * pixels_per_degree;
  Filter filter(static_cast<int>(std::ceil(3 * s)), [&](int x, int y) {
    const double along = transposed ? y : x;
    const double bell = std::exp(-(x * x + y * y) / (2 * s * s));
    return order == 1 ? -along * bell : (square(along / s) - 1) * bell;
  });
  return filter.normalize();
}

/// What the color pipeline and the feature pipeline make of one picture.
struct Seen {
  std::vector<Rgb> lab;
  std::vector<double> edges;
  std::vector<double> points;
};

/// A channel of YCxCz.
Channel channel_of(const io::RgbImage& image, std::size_t index) {
  Channel channel{image.width, image.height, {}};
  for (const auto& c : image.pixels) {
    const auto clamp = [](float v) { return std::clamp(static_cast<double>(v), 0.0, 1.0); };
    channel.values.push_back(ycxcz_from_linear({clamp(c.x), clamp(c.y), clamp(c.z)})[index]);
  }
  return channel;
}

Seen see(const io::RgbImage& image, double ppd) {
  const Channel y = channel_of(image, 0);
  const Channel cx = channel_of(image, 1);
  const Channel cz = channel_of(image, 2);
  Channel luminance = y;
  for (double& value : luminance.values) value = (value + 16) / 116;
  const std::array<Filter, 3> eye = {sensitivity(1, 0.0047, 0, 1e-5, ppd),
                                     sensitivity(1, 0.0053, 0, 1e-5, ppd),
                                     sensitivity(34.1, 0.04, 13.5, 0.025, ppd)};
  const std::array<Filter, 2> edge = {detector(1, false, ppd), detector(1, true, ppd)};
  const std::array<Filter, 2> point = {detector(2, false, ppd), detector(2, true, ppd)};
  const auto length = [&](const std::array<Filter, 2>& filters, int px, int py) {
    return std::hypot(filters[0].apply(luminance, px, py), filters[1].apply(luminance, px, py));
  };
  Seen seen;
  for (int py = 0; py < image.height; ++py) {
    for (int px = 0; px < image.width; ++px) {
      Rgb rgb = linear_from_ycxcz(
          {eye[0].apply(y, px, py), eye[1].apply(cx, px, py), eye[2].apply(cz, px, py)});
      for (double& value : rgb) value = std::clamp(value, 0.0, 1.0);
      seen.lab.push_back(hunt_lab_from_linear(rgb));
      seen.edges.push_back(length(edge, px, py));
      seen.points.push_back(length(point, px, py));
    }
  }
  return seen;
}

/// The ACES curve as fitted by Narkowicz.
double curve(double x) {
  const double e = 0.6 * x;
  return std::clamp(e * (2.51 * e + 0.03) / (e * (2.43 * e + 0.59) + 0.14), 0.0, 1.0);
}

}  // namespace

std::vector<double> plain_flip(const io::RgbImage& reference, const io::RgbImage& test,
                               double pixels_per_degree) {
  const Seen a = see(reference, pixels_per_degree);
  const Seen b = see(test, pixels_per_degree);
  const double c_max =
      std::pow(hyab(hunt_lab_from_linear({0, 1, 0}), hunt_lab_from_linear({0, 0, 1})), 0.7);
  std::vector<double> errors;
  for (std::size_t i = 0; i < a.lab.size(); ++i) {
    const double distance = std::pow(hyab(a.lab[i], b.lab[i]), 0.7);
    const double knee = 0.4 * c_max;
    const double color = distance < knee ? 0.95 * distance / knee
                                         : 0.95 + (distance - knee) / (c_max - knee) * (1 - 0.95);
    const double feature =
        std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i]));
    errors.push_back(std::pow(color, 1 - std::sqrt(feature / std::sqrt(2.0))));
  }
  return errors;
}

std::vector<double> plain_flip_hdr(const io::RgbImage& reference, const io::RgbImage& test,
                                   double pixels_per_degree) {
  double low = 0.0;
  double high = 10.0;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (curve(middle) < 0.85 ? low : high) = middle;
  }
  std::vector<double> luminances;
  for (const auto& c : reference.pixels) {
    luminances.push_back(0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z);
  }
  std::sort(luminances.begin(), luminances.end());
  const std::size_t n = luminances.size();
  const double median = (luminances[(n - 1) / 2] + luminances[n / 2]) / 2;
  const double start = std::log2(low / luminances.back());
  const double stop = std::log2(low / median);
  const int count = std::max(2, static_cast<int>(std::ceil(stop - start)));

  std::vector<double> worst(n, 0.0);
  for (int i = 0; i < count; ++i) {
    const double factor = std::exp2(start + (stop - start) * i / (count - 1));
    const auto shown = [&](io::RgbImage image) {
      for (auto& c : image.pixels) {
        c = {curve(factor * c.x), curve(factor * c.y), curve(factor * c.z)};
      }
      return image;
    };
    const auto errors = plain_flip(shown(reference), shown(test), pixels_per_degree);
    for (std::size_t p = 0; p < n; ++p) worst[p] = std::max(worst[p], errors[p]);
  }
  return worst;
}

}  // namespace lume::tests
