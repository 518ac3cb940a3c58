// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/test_image.h"

#include "io/image_tests/placeholders.h"
#include "io/image_tests/stack_file.h"
#include "renderer/cli/child_process.h"
#include "renderer/cli/render_setup.h"
#include "renderer/cli/text.h"
#include "renderer/cli/whole_file.h"

#include <fmt/format.h>

#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace lume::cli {
namespace {

namespace fs = std::filesystem;

void render_picture(const PlannedCase& planned, std::uint64_t seed, const fs::path& output,
                    const std::atomic<bool>& cancel) {
  RenderOptions options = planned.render;
  options.outputs = {output.string()};
  options.seed += seed;
  const io::WriteOptions write = prepare_outputs(options);
  RenderSetup setup;
  load(setup, options);
  build(setup, options);
  aim(setup, options);
  renderer::RenderControl control;
  control.cancel = &cancel;
  renderer::RenderResult result = trace(setup, options, control);
  if (result.cancelled) throw ImageProblem("interrupted");
  const io::Picture picture = develop(setup, options, result, write);
  io::write_picture(output, picture, write);
  const renderer::NonFiniteSamples& wrong = result.non_finite;
  if (wrong.count > 0) {
    throw ImageProblem(
        fmt::format("{} samples are infinite or NaN; the first is sample {} of pixel ({}, {})",
                    format_count(wrong.count), wrong.sample, wrong.x, wrong.y));
  }
}

/// When the file was written, if it is there.
std::optional<fs::file_time_type> time_of(const fs::path& file) {
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(file, error);
  return error ? std::nullopt : std::optional(time);
}

void run_command(const PlannedCase& planned, std::uint64_t seed, const fs::path& output,
                 const std::atomic<bool>& cancel) {
  const io::TestCase& test = planned.test;
  const fs::path& left = test.image.empty() ? output : test.image;
  const auto before = time_of(left);
  const std::string program = fs::read_symlink("/proc/self/exe").string();
  std::vector<std::string> words;
  words.reserve(test.command.size());
  for (const std::string& word : test.command) {
    words.push_back(io::fill_placeholders(word, {{"output", fs::absolute(output).string()},
                                                 {"seed", std::to_string(seed)},
                                                 {"lume", program}}));
  }
  const std::string problem =
      run_child(std::move(words), planned.start, planned.folder / "log.txt", test.timeout, cancel);
  if (!problem.empty()) throw ImageProblem(problem);
  const auto after = time_of(left);
  if (!after || after == before) {
    throw ImageProblem(fmt::format("the command has not written {}", left.string()));
  }
  if (!test.image.empty()) copy_whole(test.image, output);
}

void make_picture_file(const PlannedCase& planned, std::uint64_t seed, const fs::path& output,
                       const std::atomic<bool>& cancel) {
  std::error_code ignored;
  fs::remove(output, ignored);
  if (planned.is_render()) return render_picture(planned, seed, output, cancel);
  if (!planned.test.command.empty()) return run_command(planned, seed, output, cancel);
  if (!fs::exists(planned.test.image, ignored)) {
    throw ImageProblem(fmt::format("{} does not exist", planned.test.image.string()));
  }
  copy_whole(planned.test.image, output);
}

/// The first image of each seed's picture, as parts of one file.
void make_stack_file(const PlannedCase& planned, std::uint64_t first_seed, const fs::path& output,
                     const std::atomic<bool>& cancel) {
  const fs::path one = planned.folder / ("seed" + output.extension().string());
  std::vector<io::ChannelImage> images;
  for (int i = 0; i < planned.test.seeds; ++i) {
    const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
    make_picture_file(planned, seed, one, cancel);
    io::ImageFile file = io::read_channels(one);
    if (file.images.size() != 1) {
      throw ImageProblem(
          fmt::format("seed {} has {} images; expected one", seed, file.images.size()));
    }
    images.push_back(std::move(file.images.front()));
    images.back().name = fmt::format("seed {}", planned.render.seed + seed);
  }
  std::error_code ignored;
  fs::remove(one, ignored);
  io::write_stack(output, images);
}

}  // namespace

fs::path make_image(const PlannedCase& planned, const std::string& name, std::uint64_t first_seed,
                    const std::atomic<bool>& cancel) {
  const fs::path output = planned.picture(name);
  const bool is_file = !planned.is_render() && planned.test.command.empty();
  if (planned.test.tier == io::Tier::statistical && !is_file) {
    make_stack_file(planned, first_seed, output, cancel);
  } else {
    make_picture_file(planned, first_seed, output, cancel);
  }
  return output;
}

}  // namespace lume::cli
