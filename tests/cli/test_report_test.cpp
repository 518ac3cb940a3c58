// SPDX-License-Identifier: Apache-2.0
// The reports of `lume test`, and what it answers to what is mistyped.
#include "tests/cli/test_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace lume::cli {
namespace {

using testing::HasSubstr;

class TestReports : public TestFolder {};

TEST_F(TestReports, Reports_SayTheSame) {
  write_image("a.ppm", 10);
  write_image("references/a.ppm", 20);
  write_image("references/b.ppm", 10);
  manifest(
      "[defaults]\ntier = \"perceptual\"\nlimits = { max = 0.001 }\n[[case]]\nimage = \"a.ppm\"\n"
      "[[case]]\nname = \"b\"\nimage = \"a.ppm\"\n[[case]]\nname = \"c\"\nimage = \"a.ppm\"\nskip "
      "= \"<no>\"\n");
  const Outcome outcome = run({"--json", "-", "--junit", "j.xml", "--html", "h.html", "-q"});
  EXPECT_EQ(outcome.exit_code, 1);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["command"], "lume test m.toml --json - --junit j.xml --html h.html -q");
  EXPECT_EQ(json["counts"]["failed"], 1);
  EXPECT_EQ(json["counts"]["skipped"], 1);
  EXPECT_FALSE(std::filesystem::exists(results() / "report.json"));
  EXPECT_FALSE(std::filesystem::exists(results() / "junit.xml"));
  EXPECT_NE(read_text(folder_ / "h.html").find("</html>"), std::string::npos);

  pugi::xml_document junit;
  ASSERT_TRUE(junit.load_string(read_text(folder_ / "j.xml").c_str()));
  const pugi::xml_node suite = junit.child("testsuites").child("testsuite");
  EXPECT_EQ(suite.attribute("tests").as_int(), 3);
  EXPECT_EQ(suite.attribute("failures").as_int(), 1);
  EXPECT_EQ(suite.attribute("skipped").as_int(), 1);
  const pugi::xml_node failed = suite.find_child_by_attribute("testcase", "name", "a");
  EXPECT_EQ(failed.child("failure").attribute("message").value(), json["cases"][0]["message"]);
  EXPECT_THAT(failed.child("failure").text().get(), HasSubstr("--update changed"));
  EXPECT_TRUE(failed.child("properties").find_child_by_attribute("name", "max"));
  const pugi::xml_node skipped = suite.find_child_by_attribute("testcase", "name", "c");
  EXPECT_STREQ(skipped.child("skipped").attribute("message").value(), "<no>");
}

TEST_F(TestReports, Jobs_ChangeNothing) {
  std::string cases;
  for (int i = 0; i < 8; ++i) {
    write_image("i" + std::to_string(i) + ".ppm", i);
    cases += "[[case]]\nimage = \"i" + std::to_string(i) + ".ppm\"\n";
  }
  manifest(cases);
  const Outcome one = run();
  const Outcome many = run({"--jobs", "5"});
  EXPECT_EQ(one.exit_code, 1);
  EXPECT_EQ(one.err, many.err);
}

TEST_F(TestReports, History_KnowsSinceWhen) {
  write_image("a.ppm", 10);
  write_image("references/a.ppm", 10);
  manifest("[[case]]\nimage = \"a.ppm\"\n");
  EXPECT_EQ(run().exit_code, 0);
  EXPECT_EQ(report()["cases"][0]["failing_since"], "");
  write_image("a.ppm", 99);
  EXPECT_EQ(run().exit_code, 1);
  const std::string since = report()["cases"][0]["failing_since"];
  EXPECT_EQ(since.size(), 20u) << since;  // ISO 8601
  EXPECT_EQ(report()["cases"][0]["failures"], 1);
  EXPECT_EQ(report()["cases"][0]["runs"], 2);
  write_image("a.ppm", 10);

  test::write_bytes(results() / "history.json", "{\"version\": 1, \"runs\": 5}");
  const Outcome broken = run();
  EXPECT_EQ(broken.exit_code, 0);
  EXPECT_THAT(broken.err, HasSubstr("it begins anew"));
  EXPECT_EQ(report()["cases"][0]["runs"], 1);
}

TEST_F(TestReports, MistakesOnTheCommandLine_AreOneLine) {
  write_image("a.ppm", 10);
  manifest("[[case]]\nimage = \"a.ppm\"\n");
  const auto expect_error = [&](std::vector<std::string> arguments, int code,
                                const std::string& message) {
    const Outcome outcome = run_lume(folder_, std::move(arguments));
    EXPECT_EQ(outcome.exit_code, code) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  };
  expect_error({"test"}, 2, "no manifest given");
  expect_error({"test", "none.toml"}, 4, "none.toml: does not exist");
  expect_error({"test", "."}, 4, "is a folder");
  expect_error({"test", "m.toml", "--update", "missin"}, 2, "did you mean 'missing'?");
  expect_error({"test", "m.toml", "--json", "a", "--junit", "./a"}, 2, "the same file");
  expect_error({"test", "m.toml", "--html", "none/a.html"}, 4, "none/a.html");
  expect_error({"test", "m.toml", "--output", "a.ppm"}, 4, "a.ppm");
}

}  // namespace
}  // namespace lume::cli
