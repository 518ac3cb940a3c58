// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/test_render_options.h"

#include "io/image_io.h"
#include "io/image_tests/placeholders.h"
#include "renderer/cli/exit_codes.h"
#include "renderer/cli/suggest.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>

namespace lume::cli {
namespace {

/// Options that name what the manifest has keys for, or that say how much is to be said.
constexpr std::string_view k_refused[] = {"--output", "-o", "--stats",   "--quiet",
                                          "-q",       "-v", "--verbose", "--help"};

[[noreturn]] void reject(const CLI::App& app, const std::string& word) {
  if (word.size() < 2 || word.front() != '-') {
    throw UsageError(fmt::format("'{}' is no option; the case's scene is what is rendered", word));
  }
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  const std::string bare = word.substr(0, word.find('='));
  if (std::find(std::begin(k_refused), std::end(k_refused), bare) != std::end(k_refused)) {
    throw UsageError(fmt::format("{} is not for tests, which name their own files", bare));
  }
  throw UsageError(fmt::format("unknown option '{}'{} (lume render --help lists all)", bare,
                               did_you_mean(bare, names)));
}

void parse(const std::vector<std::string>& words, RenderOptions& options) {
  CLI::App app("", "render");
  add_render_options(app, options);
  app.remove_option(app.get_option("SCENE"));
  for (const std::string_view name : k_refused) {
    CLI::Option* option = app.get_option_no_throw(std::string(name));
    if (option != nullptr) app.remove_option(option);
  }
  app.set_help_flag();
  app.allow_extras();
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string_view text = error.what();
    throw UsageError(fmt::format("{} needs a value", text.substr(0, text.find(':'))));
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  if (!app.remaining().empty()) reject(app, app.remaining().front());
}

bool is_picture_format(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  const auto has = [&](std::span<const std::string_view> known) {
    return std::find(known.begin(), known.end(), extension) != known.end();
  };
  return has(io::scene_linear_extensions()) || has(io::display_extensions());
}

void start_in(const std::filesystem::path& folder, std::string& path) {
  if (!path.empty()) path = (folder / io::fill_environment(path)).string();
}

}  // namespace

RenderOptions read_render_options(const io::Manifest& manifest, const io::TestCase& test) {
  RenderOptions options;
  try {
    if (!is_picture_format(test.reference)) {
      throw UsageError(
          fmt::format("reference {}: no format that lume render writes", test.reference.string()));
    }
    parse(test.render, options);
    options.scene_file = test.scene.string();
    if (options.environment) start_in(manifest.folder, *options.environment);
    start_in(manifest.folder, options.ocio);
    if (options.accelerator.find('/') != std::string::npos) {
      start_in(manifest.folder, options.accelerator);
    }
    // The seeds of a stack are told apart by less than a half float holds.
    if (test.tier == io::Tier::statistical) options.full_float = true;
    options.outputs = {"actual" + test.reference.extension().string()};
    check_render_options(options);
  } catch (const UsageError& error) {
    throw io::ManifestError(manifest.file, test.line,
                            fmt::format("case '{}': render: {}", test.name, error.what()));
  }
  options.outputs.clear();
  options.verbosity = Verbosity::quiet;
  return options;
}

}  // namespace lume::cli
