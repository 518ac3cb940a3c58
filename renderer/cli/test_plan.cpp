// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/test_plan.h"

#include "io/image_tests/placeholders.h"
#include "renderer/cli/exit_codes.h"
#include "renderer/cli/suggest.h"
#include "renderer/cli/test_render_options.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <utility>

namespace lume::cli {
namespace {

std::vector<bool> choose_by(const std::vector<std::string>& names, const std::string& filter) {
  std::vector<bool> chosen(names.size(), false);
  const auto exact = std::find(names.begin(), names.end(), filter);
  if (exact != names.end()) {
    chosen[static_cast<std::size_t>(exact - names.begin())] = true;
    return chosen;
  }
  const bool is_glob = filter.find_first_of("*?[") != std::string::npos;
  for (std::size_t i = 0; i < names.size(); ++i) {
    chosen[i] =
        is_glob ? io::glob_matches(filter, names[i]) : names[i].find(filter) != std::string::npos;
  }
  return chosen;
}

std::string accept_command(const TestOptions& options, const std::string& name,
                           const char* update) {
  const std::string output = options.output == TestOptions().output
                                 ? ""
                                 : " --output " + shell_quote(printable(options.output));
  return fmt::format("lume test {} --filter {} --update {}{}",
                     shell_quote(printable(options.manifest)), shell_quote(printable(name)), update,
                     output);
}

PlannedCase plan_case(const io::Manifest& manifest, const io::TestCase& test,
                      const TestOptions& options) {
  PlannedCase planned;
  planned.test = test;
  planned.folder = std::filesystem::path(options.output) / test.name;
  planned.start = manifest.folder;
  std::error_code ignored;
  const bool is_there = std::filesystem::exists(test.reference, ignored);
  planned.accept_command = accept_command(options, test.name, is_there ? "changed" : "missing");
  if (planned.is_render()) planned.render = read_render_options(manifest, test);
  return planned;
}

}  // namespace

bool is_in_shard(const std::string& name, const Shard& shard) {
  return XXH3_64bits(name.data(), name.size()) % shard.count == shard.index - 1;
}

std::vector<bool> choose_names(const std::vector<std::string>& names,
                               const std::vector<std::string>& filters) {
  if (filters.empty()) return std::vector<bool>(names.size(), true);
  std::vector<bool> chosen(names.size(), false);
  for (const std::string& filter : filters) {
    const std::vector<bool> by_this = choose_by(names, filter);
    if (std::find(by_this.begin(), by_this.end(), true) == by_this.end()) {
      throw UsageError("--filter: " + unknown_name("case", filter, names));
    }
    for (std::size_t i = 0; i < names.size(); ++i) chosen[i] = chosen[i] || by_this[i];
  }
  return chosen;
}

std::vector<PlannedCase> plan_tests(const io::Manifest& manifest, const TestOptions& options) {
  std::vector<std::string> names;
  names.reserve(manifest.cases.size());
  for (const io::TestCase& test : manifest.cases) names.push_back(test.name);
  const std::vector<bool> chosen = choose_names(names, options.filters);
  std::vector<PlannedCase> plan;
  for (std::size_t i = 0; i < names.size(); ++i) {
    PlannedCase planned = plan_case(manifest, manifest.cases[i], options);
    if (chosen[i] && is_in_shard(names[i], options.shard)) plan.push_back(std::move(planned));
  }
  return plan;
}

}  // namespace lume::cli
