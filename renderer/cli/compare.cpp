// SPDX-License-Identifier: Apache-2.0
// `lume compare`: how far an image is from what it should be.
#include "io/error.h"
#include "io/image_tests/stack_file.h"
#include "renderer/cli/commands.h"
#include "renderer/cli/compare_report.h"
#include "renderer/cli/render_stats.h"
#include "renderer/cli/result_output.h"

#include <fmt/format.h>
#include <fnmatch.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <utility>

namespace lume::cli {
namespace {

void remove_ignored(io::ImageFile& file, const std::vector<std::string>& patterns) {
  const auto is_ignored = [&](const std::string& channel) {
    return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
      return fnmatch(pattern.c_str(), channel.c_str(), 0) == 0;
    });
  };
  for (io::ChannelImage& image : file.images) {
    for (std::size_t i = image.channels.size(); i-- > 0;) {
      if (!is_ignored(image.channels[i])) continue;
      image.channels.erase(image.channels.begin() + static_cast<std::ptrdiff_t>(i));
      image.planes.erase(image.planes.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  const auto is_empty = [](const io::ChannelImage& image) { return image.channels.empty(); };
  file.images.erase(std::remove_if(file.images.begin(), file.images.end(), is_empty),
                    file.images.end());
  if (!file.images.empty()) return;
  throw UsageError(fmt::format("--ignore: leaves nothing of {} to compare", file.path));
}

/// The image and its other seeds, as images of one file.
io::ImageFile read(const std::string& path, const std::vector<std::string>& seeds,
                   const std::vector<std::string>& ignored) {
  io::ImageFile file = io::read_channels(path);
  for (const std::string& seed : seeds) {
    for (io::ChannelImage& image : io::read_channels(seed).images) {
      file.images.push_back(std::move(image));
    }
  }
  remove_ignored(file, ignored);
  return file;
}

bool has_variance(const io::ImageFile& file) {
  const auto& channels = file.images.front().channels;
  return std::any_of(channels.begin(), channels.end(),
                     [](const std::string& name) { return name.rfind("variance.", 0) == 0; });
}

/// Colours with their variances, as two layers of an image.
io::EstimateMoments moments_of(const io::ImageFile& file) {
  const io::ChannelImage& image = file.images.front();
  const auto plane = [&](const std::string& name) -> const std::vector<float>& {
    const auto found = std::find(image.channels.begin(), image.channels.end(), name);
    if (found != image.channels.end()) {
      return image.planes[static_cast<std::size_t>(found - image.channels.begin())];
    }
    throw io::Error(
        io::ErrorKind::input_output, file.path, "",
        fmt::format("has no channel {}; expected are R, G, B and variance.R, variance.G, "
                    "variance.B",
                    name));
  };
  io::EstimateMoments moments;
  moments.shape = {image.region.width, image.region.height, {"R", "G", "B"}};
  for (const std::string& channel : moments.shape.channels) {
    moments.mean.push_back(plane(channel));
    moments.variance.push_back(plane("variance." + channel));
  }
  return moments;
}

/// Of seeds, each side keeps the mean, which is what people want to see compared.
io::StatisticalResult test_statistically(io::ImageFile& actual, io::ImageFile& expected,
                                         double significance) {
  io::StatisticalSettings settings;
  settings.significance = significance;
  if (has_variance(actual) && has_variance(expected)) {
    return io::test_moments(moments_of(actual), moments_of(expected), settings);
  }
  const io::EstimateStack actual_stack = io::stack_of(actual);
  const io::EstimateStack expected_stack = io::stack_of(expected);
  actual.images = {io::mean_of(actual)};
  expected.images = {io::mean_of(expected)};
  return io::test_stacks(actual_stack, expected_stack, settings);
}

/// Every image of either side is held against the first that is expected.
io::RefusalReason find_refusal_of_seeds(const io::ImageFile& actual,
                                        const io::ImageFile& expected) {
  const io::ImageFile first{expected.path, {expected.images.front()}};
  for (const io::ImageFile* side : {&actual, &expected}) {
    for (const io::ChannelImage& image : side->images) {
      io::RefusalReason reason = io::find_refusal({side->path, {image}}, first);
      if (reason.refusal != io::Refusal::none) return reason;
    }
  }
  return {};
}

CompareDocument compare(const CompareOptions& options) {
  CompareDocument document{options,
                           read(options.actual, options.actual_seeds, options.ignored),
                           read(options.expected, options.expected_seeds, options.ignored),
                           {},
                           {}};
  if (options.is_statistical()) {
    io::RefusalReason reason = find_refusal_of_seeds(document.actual, document.expected);
    if (reason.refusal != io::Refusal::none) {
      document.comparison.refusal = reason.refusal;
      document.comparison.message = std::move(reason.message);
      return document;
    }
    document.statistics =
        test_statistically(document.actual, document.expected, options.significance);
  }
  document.comparison = io::compare_images(document.actual, document.expected, options.settings);
  return document;
}

void write_files(const CompareDocument& document) {
  const CompareOptions& options = document.options;
  if (options.json && !options.json_to_stdout()) {
    write_text(*options.json, compare_to_json(document));
  }
  if (options.html) write_text(*options.html, compare_to_html(document));
  if (options.diff && document.comparison.has_color) write_difference(*options.diff, document);
}

ExitCode run_compare(const CompareOptions& options) {
  start_log(options.verbosity);
  check_compare_options(options);
  const CompareDocument document = compare(options);
  write_files(document);
  if (options.json_to_stdout()) {
    print_result(compare_to_json(document));
  } else if (options.verbosity != Verbosity::quiet) {
    print_result(compare_to_text(document));
  }
  return exit_code(document);
}

}  // namespace

Command add_compare_command(CLI::App& parent, std::vector<std::string> arguments) {
  // Shared with the closure, which outlives this function.
  const auto options = std::make_shared<CompareOptions>();
  options->arguments = std::move(arguments);
  CLI::App* app = parent.add_subcommand("compare", "Compare two images");
  add_compare_options(*app, *options);
  return {app, [options] { return run_compare(*options); }};
}

}  // namespace lume::cli
