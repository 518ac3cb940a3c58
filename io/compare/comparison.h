// SPDX-License-Identifier: Apache-2.0
// Two image files compared: what forbids a comparison first, then how far they are from each other,
// then what the given limits say about that.
#pragma once

#include "io/compare/channel_image.h"
#include "io/compare/flip.h"
#include "io/compare/flip_summary.h"
#include "io/compare/metrics.h"
#include "io/compare/refusal.h"

#include <optional>
#include <string>
#include <vector>

namespace lume::io {

/// What the metrics may be at most (PSNR and SSIM: at least). Without any, not one value may
/// differ. Those of pixels hold for each group of channels, SSIM and FLIP for the colour.
struct CompareLimits {
  std::optional<double> max = std::nullopt;       ///< largest absolute difference
  std::optional<double> mae = std::nullopt;       ///< mean absolute difference
  std::optional<double> rmse = std::nullopt;      ///< root of the mean squared difference
  std::optional<double> relmse = std::nullopt;    ///< mean of squared relative differences
  std::optional<double> outliers = std::nullopt;  ///< share of values far from what is expected
  std::optional<double> psnr = std::nullopt;      ///< dB
  std::optional<double> ssim = std::nullopt;
  std::optional<double> flip = std::nullopt;      ///< mean
  std::optional<double> flip_max = std::nullopt;  ///< of the worst pixel

  [[nodiscard]] bool any() const;
};

struct CompareSettings {
  CompareLimits limits;
  double pixels_per_degree = k_flip_pixels_per_degree;
};

/// What one metric was, and its limit if it has one.
struct MetricVerdict {
  std::string name;  ///< as the limit's: "rmse"; "N: rmse" for a group that is not the colour
  double value = 0.0;
  std::optional<double> limit;
  bool at_least = false;  ///< the limit is a lower one
  bool failed = false;
};

/// Channels that belong together: "" R, G, B and A; "N" N.x, N.y and N.z.
struct GroupComparison {
  std::string name;  ///< with that of the image before it, where a file holds several
  std::vector<std::string> channels;
  PixelMetrics metrics;
  int worst_x = 0;  ///< where the largest difference is, in the display window
  int worst_y = 0;
  std::string worst_channel;
};

struct Comparison {
  Refusal refusal = Refusal::none;
  std::string message;      ///< of a refusal: one line
  std::string actual_hash;  ///< pixel_hash
  std::string expected_hash;
  std::vector<GroupComparison> groups;
  bool has_color = false;
  std::size_t color_image = 0;  ///< the first image that has a colour
  bool is_hdr = false;          ///< FLIP for scene-linear images; else for display images
  double ssim = 1.0;
  FlipSummary flip;
  std::vector<float> flip_map;  ///< of the colour, one value a pixel of the data window
  std::vector<MetricVerdict> verdicts;
  bool passed = false;

  [[nodiscard]] bool identical() const { return actual_hash == expected_hash; }
};

/// Compares the images of both files by the channels' names.
[[nodiscard]] Comparison compare_images(const ImageFile& actual, const ImageFile& expected,
                                        const CompareSettings& settings);

}  // namespace lume::io
