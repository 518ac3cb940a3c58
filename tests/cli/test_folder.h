// SPDX-License-Identifier: Apache-2.0
// A folder with a manifest and small images, in which `lume test` is run.
#pragma once

#include "tests/cli/run_lume.h"
#include "tests/support/gltf_file.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace lume::cli {

class TestFolder : public testing::Test {
 protected:
  // What a CI server says of itself is said by those tests that are about it.
  TestFolder() { unsetenv("CI"); }

  void manifest(const std::string& cases) {
    test::write_bytes(folder_ / "m.toml", "version = 1\n" + cases);
  }

  /// 2 x 2 pixels of one grey; the last one may be another.
  void write_image(const std::string& name, int code, int last = -1) {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::string text = "P3 2 2 255\n";
    for (int i = 0; i < 12; ++i) text += std::to_string(i < 9 || last < 0 ? code : last) + " ";
    test::write_bytes(folder_ / name, text);
  }

  /// A triangle before a camera.
  void write_scene(const std::string& name) {
    std::filesystem::create_directories((folder_ / name).parent_path());
    test::GltfFile file = test::triangle_file();
    file.json["nodes"][1]["translation"] = {0.5, 0.5, 2.0};
    file.write(folder_ / name);
  }

  Outcome run(std::vector<std::string> arguments = {}) {
    arguments.insert(arguments.begin(), {"test", "m.toml"});
    return run_lume(folder_, std::move(arguments));
  }

  [[nodiscard]] std::filesystem::path results() const { return folder_ / "lume-test-results"; }
  [[nodiscard]] nlohmann::json report() const {
    return nlohmann::json::parse(read_text(results() / "report.json"));
  }
  [[nodiscard]] static std::set<std::string> names(const nlohmann::json& report) {
    std::set<std::string> names;
    for (const auto& one : report["cases"]) names.insert(one["name"].get<std::string>());
    return names;
  }

  tests::TemporaryFolder folder_;
};

}  // namespace lume::cli
