// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/compare_options.h"

#include "io/image_io.h"
#include "renderer/cli/distinct_files.h"
#include "renderer/cli/option_kinds.h"
#include "renderer/cli/render_stats.h"

#include <CLI/CLI.hpp>

#include <string_view>

namespace lume::cli {
namespace {

constexpr std::string_view k_examples = R"(
Without a limit, not one value may differ. With limits, each of them has to hold; which one to choose:
docs/choosing_a_tier.md. Images of all formats are taken by the names of their channels; what cannot be
compared is refused before anything is measured.

Examples:
  lume compare out.exr golden.exr
      Equal to the last bit? If not: by how much, and where.
  lume compare out.png golden.png --flip 0.005 --html difference.html
      As people see it; a page with both pictures, to slide and to blink between.
  lume compare out.exr golden.exr --rmse 0.01 --outliers 0.001 --diff difference.png
      Limits on values; a picture of the difference beside the map of FLIP.
  lume compare a1.exr b1.exr --actual-seeds a2.exr a3.exr --expected-seeds b2.exr b3.exr
      Noisy renders of several seeds: can both have the same expectation?

Exit codes: 0 equal, or within the limits; 1 not; 2 wrong command line; 4 a file cannot be read or
written; 5 other size; 6 values that are not finite; 8 other channels; 9 other data window.
)";

void add_limits(CLI::App& app, io::CompareLimits& limits) {
  const auto limit = [&](const char* name, std::optional<double>& value, const char* help) {
    app.add_option(name, value, help)
        ->check(real_between(0.0, 1e30))
        ->type_name("X")
        ->group("Limits");
  };
  limit("--max", limits.max, "Largest difference of a value");
  limit("--mae", limits.mae, "Mean absolute difference");
  limit("--rmse", limits.rmse, "Root of the mean squared difference");
  limit("--relmse", limits.relmse, "Mean squared difference, relative to the expected value");
  limit("--outliers", limits.outliers, "Share of values that are off by more than 1/500");
  limit("--psnr", limits.psnr, "Peak signal to noise, dB, at least (of a peak of 1)");
  limit("--ssim", limits.ssim, "Structural similarity, at least (1: equal)");
  limit("--flip", limits.flip, "FLIP, mean: how visible the difference is (0..1)");
  limit("--flip-max", limits.flip_max, "FLIP of the worst pixel");
}

void add_statistics(CLI::App& app, CompareOptions& options) {
  const std::string group = "Noisy images";
  const auto seeds = [&](const char* name, std::vector<std::string>& files, const char* side) {
    app.add_option(name, files, std::string("The ") + side + " image again, by other seeds")
        ->type_name("FILE...")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->group(group);
  };
  seeds("--actual-seeds", options.actual_seeds, "actual");
  seeds("--expected-seeds", options.expected_seeds, "expected");
  app.add_flag(
         "--statistical", options.statistical,
         "The files hold a seed an image, or layers variance.R, .G, .B: variances of the mean")
      ->group(group);
  app.add_option("--significance", options.significance,
                 "How often equal expectations may be told apart (0.01)")
      ->check(real_between(1e-9, 0.5))
      ->type_name("P")
      ->group(group);
}

void add_files(CLI::App& app, CompareOptions& options) {
  const std::string group = "Results";
  const auto name_or_dash = [](std::string& text) {
    return text == "-" ? std::string() : file_name()(text);
  };
  app.add_option("--json", options.json, "Write everything for programs; - is stdout")
      ->check(CLI::Validator(name_or_dash, ""))
      ->type_name("FILE")
      ->group(group);
  app.add_option("--diff", options.diff,
                 "Draw the difference (left) and FLIP (right); an .exr gets their values")
      ->check(file_name())
      ->type_name("FILE")
      ->group(group);
  app.add_option("--html", options.html,
                 "Write a page to slide, blink and zoom in; it needs no network")
      ->check(file_name())
      ->type_name("FILE")
      ->group(group);
  app.add_flag_callback(
         "-q,--quiet", [&options] { options.verbosity = Verbosity::quiet; },
         "Say nothing: the exit code does")
      ->group(group);
}

}  // namespace

void add_compare_options(CLI::App& app, CompareOptions& options) {
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.add_option("ACTUAL", options.actual, "The image in question")->type_name("FILE");
  app.add_option("EXPECTED", options.expected, "What it should be")->type_name("FILE");
  add_limits(app, options.settings.limits);
  app.add_option("--pixels-per-degree", options.settings.pixels_per_degree,
                 "How the image is looked at, for FLIP (67.02: a 4K display of 0.7 m at 0.7 m)")
      ->check(real_between(io::k_flip_least_pixels_per_degree, io::k_flip_most_pixels_per_degree))
      ->type_name("X")
      ->group("Limits");
  app.add_option("--ignore", options.ignored,
                 "Leave out channels of this name; * and ? allowed. Repeats.")
      ->type_name("PATTERN")
      ->type_size(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_statistics(app, options);
  add_files(app, options);
  app.footer(std::string(k_examples));
}

void check_compare_options(const CompareOptions& options) {
  if (options.actual.empty() || options.expected.empty()) {
    throw UsageError("two images are needed; try: lume compare ACTUAL.png EXPECTED.png");
  }
  if (options.is_statistical() && options.settings.limits.any()) {
    throw UsageError("limits are for two images, not for noisy ones with their seeds or variances");
  }
  DistinctFiles files;
  files.read("ACTUAL", options.actual);
  files.read("EXPECTED", options.expected);
  for (const std::string& file : options.actual_seeds) files.read("--actual-seeds", file);
  for (const std::string& file : options.expected_seeds) files.read("--expected-seeds", file);
  const auto write = [&](const char* role, const std::optional<std::string>& file) {
    if (!file) return;
    files.write(role, *file);
    check_text_writable(*file);
  };
  if (!options.json_to_stdout()) write("--json", options.json);
  write("--html", options.html);
  if (!options.diff) return;
  files.write("--diff", *options.diff);
  io::check_writable(*options.diff);
}

}  // namespace lume::cli
