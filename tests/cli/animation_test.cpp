// SPDX-License-Identifier: Apache-2.0
// `lume render --time`.
#include "tests/cli/run_lume.h"
#include "tests/support/gltf_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace lume::cli {
namespace {

/// The triangle slides out of the picture within a second.
std::string write_animated(const tests::TemporaryFolder& folder) {
  test::GltfFile file = test::triangle_file();
  const std::size_t times = file.add_floats({0, 1}, "SCALAR", 1);
  const std::size_t places = file.add_floats({0, 0, 0, 50, 0, 0}, "VEC3", 3);
  file.add("animations",
           {{"name", "slide"},
            {"samplers", {{{"input", times}, {"output", places}}}},
            {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}});
  return file.write(folder / "a.gltf").string();
}

Outcome render_at(const tests::TemporaryFolder& folder, const std::string& picture,
                  const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"render",       write_animated(folder),
                                        "-o",           picture,
                                        "--orbit",      "0,90,3",
                                        "--target",     "0,0,0",
                                        "--background", "1,1,1",
                                        "--width",      "16",
                                        "--height",     "16",
                                        "--spp",        "1",
                                        "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_lume(folder, arguments);
}

TEST(Animation, Time_MovesTheScene) {
  const tests::TemporaryFolder folder;
  const auto picture_of = [&](const std::string& name, const std::vector<std::string>& more) {
    const Outcome outcome = render_at(folder, (folder / name).string(), more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return read_text(folder / name);
  };
  const std::string still = picture_of("still.pfm", {});
  EXPECT_EQ(picture_of("start.pfm", {"--time", "0"}), still);
  EXPECT_EQ(picture_of("named.pfm", {"--time", "0", "--animation", "slide"}), still);
  EXPECT_NE(picture_of("later.pfm", {"--time", "1"}), still);
}

TEST(Animation, UnknownName_IsAnErrorThatListsThem) {
  const tests::TemporaryFolder folder;
  const Outcome outcome =
      render_at(folder, (folder / "a.pfm").string(), {"--time", "0", "--animation", "slid"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, testing::HasSubstr("slide"));
}

}  // namespace
}  // namespace lume::cli
