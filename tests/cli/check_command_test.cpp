// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/exit_codes.h"
#include "tests/cli/run_lume.h"
#include "tests/support/gltf_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lume::cli {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

int code(ExitCode exit_code) { return static_cast<int>(exit_code); }

TEST(CheckCommand, FileWithWarnings_SaysThemAndSucceedsUnlessToldToFail) {
  const tests::TemporaryFolder folder;
  test::triangle_file().write(folder / "a.gltf");  // has positions without bounds
  const Outcome outcome = run_lume(folder, {"check", "a.gltf"});
  EXPECT_EQ(outcome.exit_code, code(ExitCode::success));
  EXPECT_THAT(outcome.out, StartsWith("warning  /accessors/0  [bounds-missing]\n"));
  EXPECT_THAT(outcome.out, HasSubstr("a.gltf: can be rendered; 1 warning, 1 of advice"));
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_EQ(run_lume(folder, {"check", "a.gltf", "--fail-on", "warning"}).exit_code,
            code(ExitCode::differs));
}

TEST(CheckCommand, Json_HasEveryFinding) {
  const tests::TemporaryFolder folder;
  test::triangle_file().write(folder / "a.gltf");
  const Outcome outcome = run_lume(folder, {"check", "a.gltf", "--json"});
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["errors"], 0);
  EXPECT_EQ(json["warnings"], 1);
  EXPECT_EQ(json["advice"], 1);
  ASSERT_EQ(json["findings"].size(), 2u);
  EXPECT_EQ(json["findings"][0]["code"], "bounds-missing");
  EXPECT_EQ(json["findings"][0]["pointer"], "/accessors/0");
}

TEST(CheckCommand, RefusedFile_GivesItsErrorAndTheScenesExitCode) {
  const tests::TemporaryFolder folder;
  test::GltfFile file = test::triangle_file();
  file.json["accessors"][0]["count"] = 99;
  file.write(folder / "a.gltf");
  const Outcome outcome = run_lume(folder, {"check", "a.gltf"});
  EXPECT_EQ(outcome.exit_code, code(ExitCode::scene));
  EXPECT_THAT(outcome.out, StartsWith("error    /accessors/0"));
}

TEST(CheckCommand, AbsentFile_IsAnInputError) {
  const tests::TemporaryFolder folder;
  const Outcome outcome = run_lume(folder, {"check", "none.gltf"});
  EXPECT_EQ(outcome.exit_code, code(ExitCode::input_output));
  EXPECT_THAT(outcome.err, StartsWith("lume: error: none.gltf"));
}

TEST(CheckCommand, UnknownLevel_SuggestsTheNearest) {
  const tests::TemporaryFolder folder;
  const Outcome outcome = run_lume(folder, {"check", "a.gltf", "--fail-on", "warnings"});
  EXPECT_EQ(outcome.exit_code, code(ExitCode::usage));
  EXPECT_THAT(outcome.err, HasSubstr("did you mean 'warning'"));
}

}  // namespace
}  // namespace lume::cli
