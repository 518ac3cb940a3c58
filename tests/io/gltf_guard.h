// SPDX-License-Identifier: Apache-2.0
// A good glTF file is broken in one place; the loader must name that place.
#pragma once

#include "io/error.h"
#include "io/gltf/load_gltf.h"
#include "tests/support/gltf_file.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

namespace lume::test {

/// A change to the triangle file (JSON Patch, RFC 6902) and where the error is to be reported.
struct GuardCase {
  const char* name;
  const char* patch;
  const char* pointer;
};

inline std::ostream& operator<<(std::ostream& out, const GuardCase& test) {
  return out << test.name;
}

inline std::string case_name(const testing::TestParamInfo<GuardCase>& info) {
  return info.param.name;
}

/// That the file gives Error(scene) with that pointer, in one line.
inline void expect_scene_error(const nlohmann::json& json, const std::string& pointer) {
  const tests::TemporaryFolder folder;
  const auto path = folder / "broken.gltf";
  write_bytes(path, json.dump());
  const std::string start = path.string() + (pointer.empty() ? "" : " at " + pointer) + ": ";
  try {
    static_cast<void>(io::load_gltf(path));
    FAIL() << "the file loads";
  } catch (const io::Error& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.kind(), io::ErrorKind::scene) << message;
    EXPECT_EQ(message.substr(0, start.size()), start);
    EXPECT_GT(message.size(), start.size());
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

inline void expect_scene_error(const GuardCase& test) {
  expect_scene_error(triangle_file().complete().patch(nlohmann::json::parse(test.patch)),
                     test.pointer);
}

}  // namespace lume::test
