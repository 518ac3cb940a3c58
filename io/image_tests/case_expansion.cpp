// SPDX-License-Identifier: Apache-2.0
#include "io/image_tests/case_expansion.h"

#include "io/image_tests/placeholders.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace lume::io {
namespace {

namespace fs = std::filesystem;

/// The first variable that is wanted and not there; empty if there is none.
std::string missing_variable(const std::vector<std::string>& wanted) {
  for (const std::string& name : wanted) {
    if (!has_environment(name)) return name;
  }
  return "";
}

/// Refuses a variable that is not there and that the case does not say it requires.
std::string fill_declared(const ManifestTable& table, std::string_view key, const std::string& text,
                          const CaseValues& values) {
  try {
    for (const std::string& name : environment_names(text)) {
      const auto& declared = values.requires_environment;
      const bool is_declared = std::find(declared.begin(), declared.end(), name) != declared.end();
      if (is_declared || has_environment(name)) continue;
      table.fail(table.line(key),
                 fmt::format("{}: the environment has no {}; to skip the case then: "
                             "requires_environment = \"{}\"",
                             key, name, name));
    }
    return fill_environment(text);
  } catch (const std::invalid_argument& error) {
    table.fail(table.line(key), fmt::format("{}: {}", key, error.what()));
  }
}

void check_name(const ManifestTable& table, const std::string& name) {
  const bool plain = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return c >= ' ' && c != 0x7f &&
           std::string_view("/\\*?[]{}").find(static_cast<char>(c)) == std::string_view::npos;
  });
  if (plain && name.front() != '.' && name.front() != '-' && name.size() <= 200) return;
  table.fail(table.line("name"),
             fmt::format("name: '{}' cannot name a folder; expected up to 200 characters without "
                         "/ \\ * ? [ ] {{ }}, not beginning with . or -",
                         name));
}

std::string name_of(const ManifestTable& table, const std::string& stem, bool is_scene) {
  std::string name = table.text("name").value_or(stem.empty() ? "" : "{stem}");
  if (name.empty()) table.fail(table.line(), "a case of a command needs a name");
  if (is_scene || !stem.empty()) name = fill_placeholders(name, {{"stem", stem}});
  check_name(table, name);
  return name;
}

bool is_excluded(const std::vector<std::string>& excluded, const fs::path& file) {
  return std::any_of(excluded.begin(), excluded.end(), [&](const std::string& pattern) {
    return glob_matches(pattern, file.filename().string()) ||
           glob_matches(pattern, file.stem().string());
  });
}

/// The files of all patterns, those that are excluded left out.
std::vector<fs::path> scene_files(const fs::path& folder, const ManifestTable& table,
                                  const CaseValues& values) {
  const std::vector<std::string> excluded = table.texts("exclude");
  std::vector<fs::path> files;
  for (const std::string& text : table.text_or_texts("scene")) {
    const std::string pattern = fill_declared(table, "scene", text, values);
    if (!is_glob(pattern)) {
      files.push_back(folder / pattern);
      continue;
    }
    const std::vector<fs::path> found = glob_files(folder, pattern);
    if (found.empty()) {
      table.fail(table.line("scene"), fmt::format("scene: no file is like '{}'", text));
    }
    std::copy_if(found.begin(), found.end(), std::back_inserter(files),
                 [&](const fs::path& file) { return !is_excluded(excluded, file); });
  }
  if (files.empty()) table.fail(table.line("exclude"), "exclude: nothing is left of the scenes");
  return files;
}

CaseDraft named(const ManifestTable& table, const CaseValues& values, const std::string& stem,
                bool is_scene) {
  CaseDraft draft;
  draft.stem = stem;
  draft.values = values;
  draft.made.name = name_of(table, stem, is_scene);
  draft.made.line = table.line();
  return draft;
}

/// What a case is called whose files cannot be looked for.
CaseDraft absent_case(const ManifestTable& table, CaseValues values, const std::string& variable) {
  if (!values.skip) values.skip = fmt::format("the environment has no {}", variable);
  std::string stem = "scenes of line " + std::to_string(table.line());
  if (table.has("scene")) {
    const std::string pattern = fs::path(table.text_or_texts("scene").front()).stem().string();
    if (!is_glob(pattern) && !pattern.empty()) stem = pattern;
  }
  return named(table, values, stem, true);
}

void check_source(const ManifestTable& table) {
  const bool has_scene = table.has("scene");
  const bool has_other = table.has("command") || table.has("image");
  if (has_scene == has_other) {
    table.fail(table.line(), has_scene
                                 ? "scene, or command or image: a case has one image to look at"
                                 : "expected where the image comes from: scene, command or image");
  }
  if (table.has("exclude") && !has_scene) table.fail(table.line("exclude"), "exclude needs scene");
}

/// A case of a command, or of an image that is there.
CaseDraft other_case(const fs::path& folder, const ManifestTable& table, const CaseValues& values) {
  const std::vector<std::string> command = table.texts("command");
  const std::optional<std::string> image = table.text("image");
  const std::string stem =
      image && command.empty() ? fs::path(*image).stem().string() : std::string();
  CaseDraft draft = named(table, values, stem, false);
  for (const std::string& word : command) {
    draft.made.command.push_back(fill_placeholders(fill_declared(table, "command", word, values),
                                                   {{"name", draft.made.name}}));
  }
  if (image) {
    const std::string path = fill_declared(table, "image", *image, values);
    draft.made.image =
        (folder / fill_placeholders(path, {{"name", draft.made.name}})).lexically_normal();
  }
  const auto says = [&](const char* what) {
    return std::any_of(command.begin(), command.end(), [&](const std::string& word) {
      return word.find(what) != std::string::npos;
    });
  };
  if (!command.empty() && says("{output}") == image.has_value()) {
    table.fail(table.line("command"),
               "command: expected {output} among its words for where the image is to be, or image "
               "for where it is");
  }
  return draft;
}

}  // namespace

std::vector<std::string> case_keys() {
  std::vector<std::string> keys = {"name", "scene", "exclude", "command", "image"};
  const std::vector<std::string> values = case_value_keys(true);
  keys.insert(keys.end(), values.begin(), values.end());
  return keys;
}

std::vector<CaseDraft> expand_case(const fs::path& folder, const fs::path& file,
                                   const ManifestTable& table, const CaseValues& defaults) {
  CaseValues values = defaults;
  values.refine(read_case_values(file, table));
  check_source(table);
  const std::string missing = missing_variable(values.requires_environment);
  if (!missing.empty()) return {absent_case(table, values, missing)};
  if (!table.has("scene")) return {other_case(folder, table, values)};

  std::vector<CaseDraft> drafts;
  for (const fs::path& scene : scene_files(folder, table, values)) {
    drafts.push_back(named(table, values, scene.stem().string(), true));
    drafts.back().made.scene = scene.lexically_normal();
  }
  return drafts;
}

TestCase finish_case(const fs::path& file, CaseDraft draft, const fs::path& references) {
  TestCase made = std::move(draft.made);
  const CaseValues& values = draft.values;
  const auto fail = [&](const std::string& message) {
    throw ManifestError(file, made.line, fmt::format("case '{}': {}", made.name, message));
  };
  made.skip = values.skip.value_or("");
  const std::string missing = missing_variable(values.requires_environment);
  if (made.skip.empty() && !missing.empty()) {
    made.skip = fmt::format("the environment has no {}", missing);
  }
  made.tier = values.tier.value_or(made.tier);
  made.render = values.render;
  made.compare.limits = values.limits;
  made.compare.pixels_per_degree = values.pixels_per_degree.value_or(k_flip_pixels_per_degree);
  made.seeds = values.seeds.value_or(made.seeds);
  made.significance = values.significance.value_or(made.significance);
  made.timeout = values.timeout.value_or(made.timeout);

  const std::string extension = made.image.empty() ? ".exr" : made.image.extension().string();
  const std::string reference = fill_placeholders(values.reference.value_or("{name}" + extension),
                                                  {{"name", made.name}, {"stem", draft.stem}});
  if (reference.find('{') != std::string::npos) {
    fail(fmt::format("reference '{}': expected {{name}} or {{stem}} in braces", reference));
  }
  made.reference = (references / fill_environment(reference)).lexically_normal();

  if (made.tier == Tier::perceptual && !made.compare.limits.any()) {
    fail("a perceptual case needs limits, such as limits = { flip = 0.002 }");
  }
  const bool has_seed =
      std::any_of(made.command.begin(), made.command.end(),
                  [](const std::string& word) { return word.find("{seed}") != std::string::npos; });
  if (made.tier == Tier::statistical && !made.command.empty() && !has_seed) {
    fail("a statistical case runs its command with several seeds; expected {seed} in its words");
  }
  if (made.tier == Tier::statistical && made.reference.extension() != ".exr") {
    fail(fmt::format("reference '{}': a statistical case keeps a stack of images in an .exr file",
                     reference));
  }
  return made;
}

}  // namespace lume::io
