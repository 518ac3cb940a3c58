// SPDX-License-Identifier: Apache-2.0
// The test files of Khronos' glTF validator ($LUME_TEST_DATA), each with the validator's report:
// what it calls an error is refused, or loads for a reason that docs/validity.md gives.
#include "io/error.h"
#include "io/gltf/load_gltf.h"
#include "tests/support/paths.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace lume::io {
namespace {

namespace fs = std::filesystem;

struct Report {
  fs::path model;
  std::set<std::string> errors;  ///< issue codes
};

/// Without an error of the validator, but refused: docs/validity.md says why.
const std::set<std::string> k_refused_without_error = {
    "base/data/accessor/unknown_type.gltf",
    "base/data/accessor/valid.gltf",
    "base/data/accessor_data/get_elements_matrix.gltf",
    "base/data/asset/min_version_valid.gltf",
    "base/data/buffer/custom_property.gltf",
    "base/data/buffer/non_relative_uri.gltf",
    "base/data/buffer/valid_placeholder.glb",
    "base/data/camera/perspective_yfov.gltf",
    "base/data/json/integer_written_as_float.gltf",
    "base/data/mesh/valid.gltf",
    "base/data/root/named_objects.gltf",
    "base/data/root/unused_objects.gltf",
    "ext/KHR_lights_punctual/data/light/unknown_type.gltf"};

std::vector<Report> read_reports(const fs::path& folder) {
  std::vector<Report> reports;
  const std::string ending = ".report.json";
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().string();
    if (!name.ends_with(ending)) continue;
    Report report{name.substr(0, name.size() - ending.size()), {}};
    if (!fs::exists(report.model)) continue;
    const auto json = nlohmann::json::parse(std::ifstream(entry.path()));
    for (const auto& message : json["issues"]["messages"]) {
      if (message["severity"] == 0) report.errors.insert(message["code"].get<std::string>());
    }
    reports.push_back(std::move(report));
  }
  std::sort(reports.begin(), reports.end(),
            [](const Report& a, const Report& b) { return a.model < b.model; });
  return reports;
}

bool loads(const fs::path& model) {
  try {
    static_cast<void>(load_gltf(model));
    return true;
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return false;
  }
}

/// Of one issue code: how many files have it, and how many of these load.
struct Count {
  std::size_t files = 0;
  std::size_t loaded = 0;
};

struct Row {
  Count count;
  std::string reason;  ///< why some load
};

/// The rows of the table in docs/validity.md: | `CODE` | files | refused | loaded | reason |.
std::map<std::string, Row> documented_rows() {
  std::map<std::string, Row> rows;
  std::ifstream page(fs::path(LUME_SOURCE_DIR) / "docs" / "validity.md");
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| `")) continue;
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, '|');) {
      const std::size_t first = cell.find_first_not_of(' ');
      const std::size_t last = cell.find_last_not_of(' ');
      cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    }
    const std::string code = cells.at(1).substr(1, cells.at(1).size() - 2);
    rows[code] = {{std::stoul(cells.at(2)), std::stoul(cells.at(4))}, cells.at(5)};
  }
  return rows;
}

TEST(GltfValidator, FilesWithErrors_AreRefusedOrLoadForTheReasonGiven) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "LUME_TEST_DATA is not set";
  const fs::path folder = *data / "gltf" / "validator" / "glTF-Validator";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";

  const std::map<std::string, Row> documented = documented_rows();
  std::map<std::string, Count> counts;
  for (const Report& report : read_reports(folder)) {
    if (report.errors.empty()) {
      const std::string name = report.model.lexically_relative(folder).string();
      EXPECT_NE(loads(report.model), k_refused_without_error.contains(name)) << name;
      continue;
    }
    const bool loaded = loads(report.model);
    for (const std::string& code : report.errors) {
      ++counts[code].files;
      counts[code].loaded += loaded ? 1 : 0;
      if (!loaded) continue;
      const auto row = documented.find(code);
      EXPECT_TRUE(row != documented.end() && !row->second.reason.empty())
          << report.model << " loads with " << code << ", for no reason";
    }
  }
  std::string table;
  bool same = counts.size() == documented.size();
  for (const auto& [code, count] : counts) {
    const auto row = documented.find(code);
    same = same && row != documented.end() && row->second.count.files == count.files &&
           row->second.count.loaded == count.loaded;
    table +=
        fmt::format("| `{}` | {} | {} | {} | {} |\n", code, count.files, count.files - count.loaded,
                    count.loaded, row == documented.end() ? "" : row->second.reason);
  }
  EXPECT_TRUE(same) << "the table of docs/validity.md is to be\n" << table;
}

}  // namespace
}  // namespace lume::io
