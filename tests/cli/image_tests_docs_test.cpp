// SPDX-License-Identifier: Apache-2.0
// The manifest in docs/image_tests.md is one that can be run.
#include "renderer/cli/test_plan.h"
#include "tests/cli/test_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lume::cli {
namespace {

std::string manifest_of_the_docs() {
  const std::string page = read_text(tests::source_dir() / "docs/image_tests.md");
  const std::string fence = "```toml\n";
  const std::size_t begin = page.find(fence);
  if (begin == std::string::npos) return "";
  return page.substr(begin + fence.size(), page.find("```\n", begin + 1) - begin - fence.size());
}

class ImageTestsDocs : public TestFolder {};

TEST_F(ImageTestsDocs, Manifest_IsUnderstood) {
  for (const char* scene : {"broken-one", "cornell", "teapot"}) {
    write_scene("scenes/" + std::string(scene) + ".gltf");
  }
  test::write_bytes(folder_ / "m.toml", manifest_of_the_docs());
  const io::Manifest manifest = io::read_manifest(folder_ / "m.toml");
  const std::vector<PlannedCase> plan = plan_tests(manifest, {});
  std::vector<std::string> names;
  for (const PlannedCase& planned : plan) names.push_back(planned.test.name);
  EXPECT_THAT(names, testing::ElementsAre("cornell", "teapot", "ui-button", "cornell-light",
                                          testing::StartsWith("model-")));
  EXPECT_EQ(plan[0].render.spp, 64u);
  EXPECT_EQ(plan[0].test.compare.limits.flip, 0.01);
  EXPECT_EQ(plan[1].render.spp, 16u);
  EXPECT_EQ(plan[1].render.width, 96);
  EXPECT_EQ(plan[2].test.reference, folder_ / "golden/button.png");
  EXPECT_TRUE(plan[3].render.full_float);
  EXPECT_NE(plan[4].test.skip, "");
}

TEST_F(ImageTestsDocs, Manifest_Runs) {
  write_scene("scenes/cornell.gltf");
  test::write_bytes(folder_ / "make_picture", "#!/bin/sh\ncp \"$0.png\" \"$2\"\n");
  std::filesystem::permissions(folder_ / "make_picture", std::filesystem::perms::owner_all);
  ASSERT_EQ(run_lume(folder_, {"render", "-q", "scenes/cornell.gltf", "--width", "8", "-o",
                               "make_picture.png"})
                .exit_code,
            0);
  test::write_bytes(folder_ / "m.toml", manifest_of_the_docs());
  EXPECT_EQ(run({"--update", "missing"}).exit_code, 0);
  const Outcome outcome = run();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::HasSubstr("4 cases: 3 passed, 1 skipped"));
}

}  // namespace
}  // namespace lume::cli
