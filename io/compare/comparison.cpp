// SPDX-License-Identifier: Apache-2.0
#include "io/compare/comparison.h"

#include "io/compare/flip.h"
#include "io/compare/flip_hdr.h"
#include "io/compare/pixel_hash.h"
#include "io/compare/ssim.h"

#include <algorithm>
#include <map>
#include <utility>

namespace lume::io {
namespace {

/// The channels of one group, on both sides in the same order.
struct Group {
  std::vector<std::string> channels;
  std::vector<const std::vector<float>*> actual;
  std::vector<const std::vector<float>*> expected;
};

/// "N" of "N.x", nothing of "R": layers as EXR names them.
std::string group_name(const std::string& channel) {
  const std::size_t dot = channel.rfind('.');
  return dot == std::string::npos ? "" : channel.substr(0, dot);
}

const std::vector<float>& plane_of(const ChannelImage& image, const std::string& channel) {
  const auto found = std::find(image.channels.begin(), image.channels.end(), channel);
  return image.planes[static_cast<std::size_t>(found - image.channels.begin())];
}

std::map<std::string, Group> group_channels(const ChannelImage& actual,
                                            const ChannelImage& expected) {
  std::map<std::string, Group> groups;
  for (std::size_t i = 0; i < expected.channels.size(); ++i) {
    const std::string& channel = expected.channels[i];
    Group& group = groups[group_name(channel)];
    group.channels.push_back(channel);
    group.actual.push_back(&plane_of(actual, channel));
    group.expected.push_back(&expected.planes[i]);
  }
  return groups;
}

std::string full_name(const ImageFile& file, std::size_t image, const std::string& group) {
  if (file.images.size() == 1) return group;
  const std::string& part = file.images[image].name;
  const std::string prefix = part.empty() ? std::to_string(image + 1) : part;
  return group.empty() ? prefix : prefix + "." + group;
}

GroupComparison compare_group(std::string name, Group group, const shading::PixelRegion& region) {
  GroupComparison result{
      std::move(name), std::move(group.channels), measure(group.actual, group.expected), 0, 0, {}};
  const auto worst = static_cast<int>(result.metrics.worst_index);
  result.worst_x = region.x + worst % region.width;
  result.worst_y = region.y + worst / region.width;
  result.worst_channel = result.channels[result.metrics.worst_plane];
  return result;
}

void compare_values(const ImageFile& actual, const ImageFile& expected, Comparison& result) {
  for (std::size_t i = 0; i < expected.images.size(); ++i) {
    const ChannelImage& image = expected.images[i];
    for (auto& [name, group] : group_channels(actual.images[i], image)) {
      result.groups.push_back(
          compare_group(full_name(expected, i, name), std::move(group), image.region));
    }
  }
}

void compare_colors(const ImageFile& actual, const ImageFile& expected, double pixels_per_degree,
                    Comparison& result) {
  const auto found = std::find_if(expected.images.begin(), expected.images.end(), has_color);
  result.has_color = found != expected.images.end();
  if (!result.has_color) return;
  result.color_image = static_cast<std::size_t>(found - expected.images.begin());
  const ChannelImage& other = actual.images[result.color_image];
  result.is_hdr = !found->display_referred && !other.display_referred;
  const RgbImage reference = color_of(*found);
  const RgbImage test = color_of(other);
  const FlipOptions options{pixels_per_degree};
  result.flip_map =
      result.is_hdr ? flip_hdr(reference, test, options).error : flip(reference, test, options);
  result.flip = summarize_flip(result.flip_map);
  result.ssim = ssim(test, reference);
}

class Judge {
 public:
  explicit Judge(Comparison& comparison) : comparison_(comparison) {}

  void at_most(const std::string& name, double value, const std::optional<double>& limit) {
    add({name, value, limit, false, limit && !(value <= *limit)});
  }
  void at_least(const std::string& name, double value, const std::optional<double>& limit) {
    add({name, value, limit, true, limit && !(value >= *limit)});
  }

 private:
  void add(MetricVerdict verdict) {
    comparison_.passed = comparison_.passed && !verdict.failed;
    comparison_.verdicts.push_back(std::move(verdict));
  }

  Comparison& comparison_;
};

void judge(const CompareLimits& limits, Comparison& comparison) {
  comparison.passed = limits.any() || comparison.identical();
  Judge judge(comparison);
  for (const GroupComparison& group : comparison.groups) {
    const std::string prefix = group.name.empty() ? "" : group.name + ": ";
    const PixelMetrics& metrics = group.metrics;
    judge.at_most(prefix + "max", metrics.max, limits.max);
    judge.at_most(prefix + "mae", metrics.mae, limits.mae);
    judge.at_most(prefix + "rmse", metrics.rmse, limits.rmse);
    judge.at_most(prefix + "relmse", metrics.relmse, limits.relmse);
    judge.at_most(prefix + "outliers", metrics.outliers, limits.outliers);
    judge.at_least(prefix + "psnr", metrics.psnr, limits.psnr);
  }
  if (!comparison.has_color) return;
  judge.at_least("ssim", comparison.ssim, limits.ssim);
  judge.at_most("flip", comparison.flip.mean, limits.flip);
  judge.at_most("flip_max", comparison.flip.max, limits.flip_max);
}

}  // namespace

bool CompareLimits::any() const {
  return max || mae || rmse || relmse || outliers || psnr || ssim || flip || flip_max;
}

Comparison compare_images(const ImageFile& actual, const ImageFile& expected,
                          const CompareSettings& settings) {
  Comparison result;
  result.actual_hash = pixel_hash(actual);
  result.expected_hash = pixel_hash(expected);
  auto [refusal, message] = find_refusal(actual, expected);
  result.refusal = refusal;
  result.message = std::move(message);
  if (refusal != Refusal::none) return result;
  compare_values(actual, expected, result);
  compare_colors(actual, expected, settings.pixels_per_degree, result);
  judge(settings.limits, result);
  return result;
}

}  // namespace lume::io
