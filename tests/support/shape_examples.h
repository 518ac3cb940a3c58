// SPDX-License-Identifier: Apache-2.0
// The files that pages in docs show, and the schemas beside them.
#pragma once

#include "tests/support/json_schema.h"
#include "tests/support/paths.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace lume::test {

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Every ```json block of a page.
inline std::vector<nlohmann::json> page_examples(const std::string& name) {
  const std::string start = "```json\n";
  const std::string page = read_text(tests::source_dir() / "docs" / name);
  std::vector<nlohmann::json> examples;
  for (std::size_t at = page.find(start); at != std::string::npos; at = page.find(start, at)) {
    at += start.size();
    examples.push_back(nlohmann::json::parse(page.substr(at, page.find("\n```", at) - at)));
  }
  return examples;
}

inline std::vector<nlohmann::json> shape_examples() { return page_examples("shapes.md"); }

/// Every shape of all examples.
inline std::vector<nlohmann::json> example_shapes() {
  std::vector<nlohmann::json> shapes;
  for (const nlohmann::json& example : shape_examples()) {
    const nlohmann::json& list =
        example.contains("shapes")
            ? example.at("shapes")
            : example.at("extensions").at("KHR_implicit_shapes").at("shapes");
    shapes.insert(shapes.end(), list.begin(), list.end());
  }
  return shapes;
}

inline std::filesystem::path schema_path(const std::string& name) {
  return tests::source_dir() / "docs/schema" / (name + ".schema.json");
}

inline JsonSchema load_schema(const std::string& name) {
  return JsonSchema(nlohmann::json::parse(read_text(schema_path(name))));
}

}  // namespace lume::test
