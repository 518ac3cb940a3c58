// SPDX-License-Identifier: Apache-2.0
#include "io/image_tests/manifest.h"

#include "io/error.h"
#include "io/image_tests/case_expansion.h"
#include "io/image_tests/placeholders.h"
#include "io/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <utility>

namespace lume::io {
namespace {

namespace fs = std::filesystem;

constexpr int k_version = 1;

toml::table parse_file(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    throw Error(ErrorKind::input_output, path.string(), "", "is a folder, expected a manifest");
  }
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  if (stream) text << stream.rdbuf();
  if (!stream) {
    throw Error(ErrorKind::input_output, path.string(), "",
                fs::exists(path, ignored) ? "cannot be read" : "does not exist");
  }
  try {
    return toml::parse(text.str(), path.string());
  } catch (const toml::parse_error& error) {
    throw ManifestError(path, static_cast<int>(error.source().begin.line),
                        std::string(error.description()));
  }
}

void check_version(const ManifestTable& top) {
  if (!top.has("version")) {
    top.fail(1, fmt::format("no version is given; expected: version = {}", k_version));
  }
  const std::optional<int> version = top.whole("version", 0, 1 << 20);
  if (*version != k_version) {
    top.fail(top.line("version"),
             fmt::format("version {} is not known; expected {}", *version, k_version));
  }
}

struct Defaults {
  CaseValues values;
  fs::path references;
};

Defaults read_defaults(const ManifestTable& top, const fs::path& file, const fs::path& folder) {
  Defaults defaults{{}, folder / "references"};
  const toml::table* table = top.table("defaults");
  if (table == nullptr) return defaults;
  std::vector<std::string> keys = case_value_keys(false);
  keys.emplace_back("references");
  const ManifestTable given(file, *table, "[defaults]", keys);
  defaults.values = read_case_values(file, given);
  if (const auto references = given.text("references")) {
    defaults.references = folder / fill_environment(*references);
  }
  return defaults;
}

void check_names(const fs::path& file, const std::vector<CaseDraft>& drafts) {
  std::map<std::string, const CaseDraft*> seen;
  for (const CaseDraft& draft : drafts) {
    const auto [other, is_new] = seen.emplace(draft.made.name, &draft);
    if (is_new) continue;
    const auto place = [](const TestCase& made) {
      const std::string scene = made.scene.empty() ? "" : " (" + made.scene.string() + ")";
      return fmt::format("line {}{}", made.line, scene);
    };
    throw ManifestError(
        file, draft.made.line,
        fmt::format("two cases have the name '{}': of {} and of {}; give them a "
                    "name, which may hold {{stem}}",
                    draft.made.name, place(other->second->made), place(draft.made)));
  }
}

void apply_override(const fs::path& file, const toml::table& table,
                    std::vector<CaseDraft>& drafts) {
  std::vector<std::string> keys = case_value_keys(true);
  keys.emplace_back("name");
  const ManifestTable given(file, table, "[[override]]", keys);
  const CaseValues values = read_case_values(file, given);
  if (!given.has("name")) {
    given.fail(given.line(), "expected a name: which cases to change, * and ? allowed");
  }
  for (const std::string& pattern : given.text_or_texts("name")) {
    bool any = false;
    for (CaseDraft& draft : drafts) {
      if (!glob_matches(pattern, draft.made.name)) continue;
      any = true;
      draft.values.refine(values);
    }
    if (any) continue;
    std::vector<std::string> names;
    names.reserve(drafts.size());
    for (const CaseDraft& draft : drafts) names.push_back(draft.made.name);
    given.fail(given.line("name"),
               fmt::format("name: no case is called '{}'{}", pattern, list_names(pattern, names)));
  }
}

void check_references(const fs::path& file, const std::vector<TestCase>& cases) {
  std::map<fs::path, const TestCase*> seen;
  for (const TestCase& made : cases) {
    const auto [other, is_new] = seen.emplace(made.reference.lexically_normal(), &made);
    // One reference may be that of several ways to make an image, as long as all are held to it in
    // the same way.
    if (is_new || other->second->tier == made.tier) continue;
    throw ManifestError(file, made.line,
                        fmt::format("case '{}': its reference is that of '{}' (line {}), which is "
                                    "of another tier",
                                    made.name, other->second->name, other->second->line));
  }
}

}  // namespace

Manifest read_manifest(const fs::path& file) {
  const toml::table root = parse_file(file);
  const ManifestTable top(file, root, "manifest", {"version", "defaults", "case", "override"});
  check_version(top);
  // A folder that is named, so that a program in it can be started as folder/program.
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const Defaults defaults = read_defaults(top, file, folder);

  std::vector<CaseDraft> drafts;
  for (const toml::table* table : top.tables("case")) {
    const ManifestTable given(file, *table, "[[case]]", case_keys());
    for (CaseDraft& draft : expand_case(folder, file, given, defaults.values)) {
      drafts.push_back(std::move(draft));
    }
  }
  if (drafts.empty()) top.fail(1, "there is no [[case]]");
  check_names(file, drafts);
  for (const toml::table* table : top.tables("override")) apply_override(file, *table, drafts);

  Manifest manifest{file, folder, {}};
  manifest.cases.reserve(drafts.size());
  for (CaseDraft& draft : drafts) {
    manifest.cases.push_back(finish_case(file, std::move(draft), defaults.references));
  }
  check_references(file, manifest.cases);
  return manifest;
}

}  // namespace lume::io
