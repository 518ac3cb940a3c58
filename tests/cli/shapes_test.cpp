// SPDX-License-Identifier: Apache-2.0
// Analytic shapes on the command line, in the files that docs/shapes.md shows.
#include "tests/cli/run_lume.h"
#include "tests/support/gltf_file.h"
#include "tests/support/shape_examples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace lume::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The page's sphere that stands in place of an octahedron.
std::string write_bound_primitive(const tests::TemporaryFolder& folder) {
  test::write_bytes(folder / "a.gltf", test::shape_examples().at(1).dump());
  return (folder / "a.gltf").string();
}

TEST(Shapes, Info_CountsThemBesideTriangles) {
  const tests::TemporaryFolder folder;
  test::write_bytes(folder / "a.gltf", test::shape_examples().at(0).dump());
  const std::string file = (folder / "a.gltf").string();
  EXPECT_THAT(run_lume(folder, {"info", file}).out, HasSubstr("1 analytic shapes (2 as placed)"));
  const auto info = nlohmann::json::parse(run_lume(folder, {"info", "--json", file}).out);
  EXPECT_EQ(info.at("counts").at("shapes"), 1);
  EXPECT_EQ(info.at("counts").at("shapes_instanced"), 2);
  EXPECT_EQ(info.at("counts").at("triangles"), 0);
}

TEST(Shapes, Tessellated_DrawsTheTrianglesInstead) {
  const tests::TemporaryFolder folder;
  const std::string file = write_bound_primitive(folder);
  const auto picture_of = [&](const std::string& name, const std::vector<std::string>& more) {
    const std::string picture = (folder / name).string();
    std::vector<std::string> arguments = {
        "render",   file, "-o",    picture, "--orbit", "90,90,3",      "--width", "32",
        "--height", "32", "--spp", "1",     "--quiet", "--background", "1,1,1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_lume(folder, arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return test::read_text(picture);
  };
  EXPECT_NE(picture_of("shape.pfm", {}), picture_of("triangles.pfm", {"--tessellated"}));
}

TEST(Shapes, EndlessPlaneAlone_IsASceneWithSurfaces) {
  const tests::TemporaryFolder folder;
  const auto plane = nlohmann::json::parse(R"({"asset": {"version": "2.0"},
      "extensions": {"KHR_implicit_shapes": {"shapes": [{"type": "plane"}]}},
      "nodes": [{"extensions": {"LUME_shape": {"shape": 0}}}]})");
  test::write_bytes(folder / "a.gltf", plane.dump());
  const Outcome outcome =
      run_lume(folder, {"render", (folder / "a.gltf").string(), "-o", (folder / "a.pfm").string(),
                        "--orbit", "0,60,3", "--width", "8", "--height", "8", "--spp", "1"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, Not(HasSubstr("no surfaces")));
}

}  // namespace
}  // namespace lume::cli
