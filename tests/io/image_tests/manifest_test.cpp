// SPDX-License-Identifier: Apache-2.0
// Manifests of image tests: what they stand for, and what is said of those that are wrong.
#include "io/image_tests/manifest.h"

#include "io/error.h"
#include "io/image_tests/placeholders.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace lume::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ManifestFile : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
  }

  Manifest read(const std::string& text) {
    write("m.toml", "version = 1\n" + text);
    return read_manifest(folder_ / "m.toml");
  }

  static std::vector<std::string> names(const Manifest& manifest) {
    std::vector<std::string> names;
    for (const TestCase& test : manifest.cases) names.push_back(test.name);
    return names;
  }

  /// The text stands below "version = 1", so its first line is line 2.
  void expect_error(const std::string& text, int line, const std::string& message) {
    try {
      (void)read(text);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const ManifestError& error) {
      const std::string said = error.what();
      EXPECT_THAT(said, HasSubstr("m.toml:" + std::to_string(line) + ": ")) << text;
      EXPECT_THAT(said, HasSubstr(message)) << text;
      EXPECT_EQ(said.find('\n'), std::string::npos) << text;
    }
  }

  tests::TemporaryFolder folder_;
};

TEST_F(ManifestFile, Globs_BecomeACaseAFile) {
  for (const char* name : {"b.gltf", "a.gltf", "c.glb", "note.txt", "old.gltf"}) {
    write(std::string("scenes/") + name, "");
  }
  const Manifest manifest = read(R"(
[defaults]
references = "golden"
[[case]]
scene = "scenes/*.{gltf,glb}"
exclude = ["old"]
[[case]]
scene = ["scenes/a.gltf", "scenes/[b]*"]
name = "again-{stem}"
reference = "{stem}.png"
)");
  EXPECT_THAT(names(manifest), ElementsAre("a", "b", "c", "again-a", "again-b"));
  EXPECT_EQ(manifest.cases[0].scene, folder_ / "scenes/a.gltf");
  EXPECT_EQ(manifest.cases[0].reference, folder_ / "golden/a.exr");
  EXPECT_EQ(manifest.cases[0].line, 5);
  EXPECT_EQ(manifest.cases[4].reference, folder_ / "golden/b.png");
  EXPECT_EQ(manifest.cases[4].tier, Tier::exact);
}

TEST_F(ManifestFile, FolderThatLooksLikeAGlob_IsTakenAsItIs) {
  write("[x]{a,b}*/s/a.gltf", "");
  write("[x]{a,b}*/m.toml", "version = 1\n[[case]]\nscene = \"s/*\"\n");
  EXPECT_THAT(names(read_manifest(folder_ / "[x]{a,b}*/m.toml")), ElementsAre("a"));
}

TEST_F(ManifestFile, LaterTables_RefineEarlierOnes) {
  const Manifest manifest = read(R"(
[defaults]
tier = "perceptual"
render = "--spp 16 --env 'my sky.hdr'"
limits = { flip = 0.01, max = 1 }
seeds = 4
[[case]]
scene = "a.gltf"
[[case]]
scene = "b.gltf"
render = ["--spp", "4"]
limits = { max = 2 }
tier = "statistical"
[[override]]
name = "b*"
render = "--aov depth"
seeds = 12
significance = 0.001
[[override]]
name = ["a", "b"]
skip = "not today"
)");
  const TestCase& a = manifest.cases[0];
  const TestCase& b = manifest.cases[1];
  EXPECT_THAT(a.render, ElementsAre("--spp", "16", "--env", "my sky.hdr"));
  EXPECT_THAT(b.render,
              ElementsAre("--spp", "16", "--env", "my sky.hdr", "--spp", "4", "--aov", "depth"));
  EXPECT_EQ(a.compare.limits.max, 1.0);
  EXPECT_EQ(b.compare.limits.max, 2.0);
  EXPECT_EQ(b.compare.limits.flip, 0.01);
  EXPECT_EQ(a.tier, Tier::perceptual);
  EXPECT_EQ(b.tier, Tier::statistical);
  EXPECT_EQ(a.seeds, 4);
  EXPECT_EQ(b.seeds, 12);
  EXPECT_EQ(b.significance, 0.001);
  EXPECT_EQ(a.skip, "not today");
}

TEST_F(ManifestFile, Commands_KeepWhatIsOnlyKnownLater) {
  const Manifest manifest = read(R"(
[[case]]
name = "button"
command = ["./draw", "--name={name}", "{output}", "{}", "{other}"]
reference = "button.png"
timeout = 2.5
[[case]]
name = "left"
command = ["make", "{name}"]
image = "out/{name}.png"
[[case]]
image = "there.tif"
)");
  EXPECT_THAT(manifest.cases[0].command,
              ElementsAre("./draw", "--name=button", "{output}", "{}", "{other}"));
  EXPECT_EQ(manifest.cases[0].timeout, 2.5);
  EXPECT_EQ(manifest.cases[1].image, folder_ / "out/left.png");
  EXPECT_EQ(manifest.cases[1].reference, folder_ / "references/left.png");
  EXPECT_EQ(manifest.cases[2].name, "there");
  EXPECT_EQ(manifest.cases[2].reference, folder_ / "references/there.tif");
}

TEST_F(ManifestFile, Environment_IsFilledInOrSkips) {
  write("data/x.gltf", "");
  setenv("LUME_MANIFEST_TEST", (folder_ / "data").c_str(), 1);
  const std::string text = R"(
[[case]]
scene = "${LUME_MANIFEST_TEST}/*.gltf"
requires_environment = "LUME_MANIFEST_TEST"
)";
  const Manifest there = read(text);
  EXPECT_THAT(names(there), ElementsAre("x"));
  EXPECT_EQ(there.cases[0].scene, folder_ / "data/x.gltf");
  EXPECT_EQ(there.cases[0].skip, "");

  unsetenv("LUME_MANIFEST_TEST");
  const Manifest absent = read(text);
  ASSERT_EQ(absent.cases.size(), 1u);
  EXPECT_THAT(absent.cases[0].skip, HasSubstr("LUME_MANIFEST_TEST"));
  expect_error("[[case]]\nscene = \"${LUME_MANIFEST_TEST}/a.gltf\"\n", 3, "requires_environment");
  expect_error("[[case]]\nscene = \"${LUME_MANIFEST\"\n", 3, "without a '}'");
}

TEST_F(ManifestFile, Mistakes_NameTheirLine) {
  expect_error("[[case]\n", 2, "");
  expect_error("colour = 1\n[[case]]\nscene = \"a.gltf\"\n", 2, "unknown key 'colour'");
  expect_error("", 1, "no [[case]]");
  expect_error("[case]\nscene = \"a.gltf\"\n", 2, "each under a line [[case]]");
  expect_error("[defaults]\n\ntier = \"exakt\"\n", 4, "did you mean exact?");
  expect_error("[defaults]\nscene = \"a\"\n", 3, "unknown key 'scene'");
  expect_error("\n[[case]]\nscen = \"a.gltf\"\n", 4, "did you mean scene?");
  expect_error("[[case]]\nscene = 5\n", 3, "expected a string or an array of strings, found 5");
  expect_error("[[case]]\nscene = \"\"\n", 3, "not empty");
  expect_error("[[case]]\nscene = [\"a\", 5]\n", 3, "expected strings, found 5");
  expect_error("[[case]]\nname = \"a\"\n", 2, "expected where the image comes from");
  expect_error("[[case]]\nscene = \"a\"\nimage = \"b\"\n", 2, "one image");
  expect_error("[[case]]\nscene = \"*.none\"\n", 3, "no file is like '*.none'");
  expect_error("[[case]]\nname = \"a/b\"\nscene = \"a\"\n", 3, "cannot name a folder");
  expect_error("[[case]]\nname = \"..\"\nscene = \"a\"\n", 3, "cannot name a folder");
  expect_error("[[case]]\ncommand = [\"a\", \"{output}\"]\n", 2, "needs a name");
  expect_error("[[case]]\nname = \"a\"\ncommand = [\"a\"]\n", 4, "{output}");
  expect_error("[[case]]\nname = \"a\"\ncommand = []\n", 4, "at least one");
  expect_error("[[case]]\nimage = \"a.png\"\nexclude = [\"b\"]\n", 4, "exclude needs scene");
  expect_error("[[case]]\nscene = \"a\"\nlimits = { rsme = 1 }\n", 4, "did you mean rmse?");
  expect_error("[[case]]\nscene = \"a\"\nlimits = { rmse = -1 }\n", 4, "at least 0, found -1");
  expect_error("[[case]]\nscene = \"a\"\nlimits = { rmse = inf }\n", 4, "finite");
  expect_error("[[case]]\nscene = \"a\"\nseeds = 1\n", 4, "whole number from 2 to 1024");
  expect_error("[[case]]\nscene = \"a\"\nseeds = 2.5\n", 4, "found 2.5");
  expect_error("[[case]]\nscene = \"a\"\ntimeout = 0\n", 4, "timeout");
  expect_error("[[case]]\nscene = \"a\"\nrender = \"--env 'x\"\n", 4, "a quote does not end");
  expect_error("[[case]]\nscene = \"a\"\ntier = \"perceptual\"\n", 2, "needs limits");
  expect_error("[[case]]\nscene = \"a\"\nreference = \"{nam}.exr\"\n", 2, "{nam}");
  expect_error("[[case]]\nscene = \"a\"\ntier = \"statistical\"\nreference = \"a.png\"\n", 2,
               ".exr");
  expect_error("[[case]]\nname = \"a\"\ntier = \"statistical\"\ncommand = [\"a\", \"{output}\"]\n",
               2, "{seed}");
  expect_error("[[case]]\nscene = \"a.gltf\"\n[[case]]\nscene = \"b/a.gltf\"\n", 4,
               "two cases have the name 'a': of line 2");
  expect_error("[[case]]\nscene = \"cornell\"\n[[override]]\nname = \"cornel\"\n", 5,
               "did you mean cornell?");
  expect_error("[[case]]\nscene = \"a\"\n[[override]]\nskip = \"x\"\n", 4, "expected a name");
  expect_error(
      "[[case]]\nscene = \"a\"\n[[case]]\nscene = \"b\"\nreference = \"a.exr\"\ntier = "
      "\"statistical\"\n",
      4, "its reference is that of 'a' (line 2)");
}

TEST_F(ManifestFile, Version_IsAskedFor) {
  write("m.toml", "[[case]]\nscene = \"a.gltf\"\n");
  EXPECT_THROW((void)read_manifest(folder_ / "m.toml"), ManifestError);
  write("m.toml", "version = 2\n[[case]]\nscene = \"a.gltf\"\n");
  EXPECT_THROW((void)read_manifest(folder_ / "m.toml"), ManifestError);
}

TEST_F(ManifestFile, FilesThatCannotBeRead_AreErrorsOfTheirOwn) {
  EXPECT_THROW((void)read_manifest(folder_ / "none.toml"), Error);
  EXPECT_THROW((void)read_manifest(folder_.path()), Error);
}

TEST(Placeholders, Words_AreThoseOfAShell) {
  EXPECT_THAT(split_words("  a 'b c'  --d=\"e f\"'g' '' "),
              ElementsAre("a", "b c", "--d=e fg", ""));
  EXPECT_THAT(split_words(""), ElementsAre());
  EXPECT_THROW((void)split_words("a \"b"), std::invalid_argument);
}

TEST(Placeholders, WhatIsPutIn_IsNotLookedAtAgain) {
  EXPECT_EQ(fill_placeholders("{a}{b}{c}{", {{"a", "{b}"}, {"b", "x"}}), "{b}x{c}{");
}

}  // namespace
}  // namespace lume::io
