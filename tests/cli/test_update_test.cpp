// SPDX-License-Identifier: Apache-2.0
// `lume test --update` and `--repeat` from the outside: what becomes a reference.
#include "renderer/cli/exit_codes.h"
#include "renderer/cli/test_options.h"
#include "tests/cli/test_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace lume::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class TestUpdate : public TestFolder {};

TEST_F(TestUpdate, MissingReference_FailsUntilItIsAccepted) {
  write_image("a b.ppm", 10);
  manifest("[[case]]\nimage = \"a b.ppm\"\n[[case]]\nname = \"a b c\"\nimage = \"a b.ppm\"\n");
  const Outcome missing = run();
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_THAT(missing.err, HasSubstr("lume test m.toml --filter 'a b' --update missing\n"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "references"));

  // The command as it was shown: it is about this case alone, though another name begins with it.
  const Outcome update = run({"--filter", "a b", "--update", "missing"});
  EXPECT_EQ(update.exit_code, 0) << update.err;
  EXPECT_EQ(update.err, "");
  EXPECT_THAT(update.out, HasSubstr("new: references/a b.ppm\n"));
  EXPECT_THAT(update.out, HasSubstr("1 case: 1 accepted"));
  EXPECT_EQ(read_text(folder_ / "references/a b.ppm"), read_text(folder_ / "a b.ppm"));
  EXPECT_EQ(run({"--filter", "a b"}).exit_code, 0);
}

TEST_F(TestUpdate, UpdateModes_WriteWhatTheyName) {
  for (const char* name : {"same", "other", "near", "new"}) {
    write_image(std::string(name) + ".ppm", 10);
  }
  const auto prepare = [&] {
    write_image("references/same.ppm", 10);
    write_image("references/other.ppm", 200);
    write_image("references/near.ppm", 11);
    std::filesystem::remove(folder_ / "references/new.ppm");
  };
  manifest(
      "[defaults]\ntier = \"perceptual\"\nlimits = { max = 0.01 }\n"
      "[[case]]\nimage = \"same.ppm\"\n[[case]]\nimage = \"other.ppm\"\n"
      "[[case]]\nimage = \"near.ppm\"\n[[case]]\nimage = \"new.ppm\"\n");
  const std::string image = read_text(folder_ / "same.ppm");
  const auto written = [&](const char* name) {
    return read_text(folder_ / "references" / (std::string(name) + ".ppm")) == image;
  };

  prepare();
  const Outcome missing = run({"--update", "missing"});
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_TRUE(written("new"));
  EXPECT_FALSE(written("other"));

  prepare();
  const Outcome changed = run({"--update", "changed"});
  EXPECT_EQ(changed.exit_code, 0);
  EXPECT_TRUE(written("new"));
  EXPECT_TRUE(written("other"));
  EXPECT_FALSE(written("near"));
  EXPECT_THAT(changed.out, HasSubstr("unchanged: references/same.ppm\n"));
  EXPECT_THAT(changed.out, HasSubstr("changed: references/other.ppm (it was: max 0."));
  EXPECT_THAT(changed.out, HasSubstr("unchanged: references/near.ppm\n"));

  prepare();
  EXPECT_EQ(run({"--update", "all"}).exit_code, 0);
  EXPECT_TRUE(written("near"));
  const Outcome again = run({"--update", "all"});
  EXPECT_THAT(again.out, AllOf(HasSubstr("4 passed"), Not(HasSubstr("\nchanged"))));
}

TEST_F(TestUpdate, UpdateUnderCi_IsRefused) {
  write_image("a.ppm", 10);
  manifest("[[case]]\nimage = \"a.ppm\"\n");
  setenv("CI", "true", 1);
  const Outcome refused = run({"--update", "missing"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--force"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "references"));
  EXPECT_EQ(run({"--update", "missing", "--force"}).exit_code, 0);

  TestOptions options;
  options.manifest = "m.toml";
  options.update = ReferenceUpdate::all;
  for (const char* yes : {"true", "1", "woodpecker"}) {
    setenv("CI", yes, 1);
    EXPECT_THROW(check_test_options(options), UsageError) << yes;
  }
  for (const char* no : {"", "0", "false", "False"}) {
    setenv("CI", no, 1);
    EXPECT_NO_THROW(check_test_options(options)) << no;
  }
  unsetenv("CI");
}

TEST_F(TestUpdate, Repeat_FindsWhatIsNotTheSameEachTime) {
  write_image("same.ppm", 10);
  write_image("references/same.ppm", 10);
  write_image("references/odd.ppm", 10);
  manifest(
      "[[case]]\nimage = \"same.ppm\"\n[[case]]\nname = \"odd\"\nimage = \"odd.ppm\"\n"
      "command = [\"sh\", \"-c\", \"echo x >> n; printf 'P3 1 1 255 %s 0 0' $(wc -l < n) > "
      "odd.ppm\"]\n"
      "tier = \"perceptual\"\nlimits = { max = 1 }\n[[override]]\nname = \"odd\"\n"
      "reference = \"{name}.ppm\"\n");
  test::write_bytes(folder_ / "references/odd.ppm", "P3 1 1 255 1 0 0");
  EXPECT_EQ(run().exit_code, 0);
  const Outcome outcome = run({"--repeat", "3"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("flaky: odd: run 2 of 3 differs from the first"));
  EXPECT_THAT(outcome.out, HasSubstr("2 cases: 1 passed, 1 flaky"));
  EXPECT_EQ(run({"--repeat", "3", "--update", "all"}).exit_code, 1);
}

}  // namespace
}  // namespace lume::cli
