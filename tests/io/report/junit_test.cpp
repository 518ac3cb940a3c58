// SPDX-License-Identifier: Apache-2.0
// JUnit XML, as those who read it find it.
#include "io/report/junit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <string>

namespace lume::io {
namespace {

using testing::HasSubstr;
using testing::Not;
using Outcome = JunitCase::Outcome;

JunitSuite example() {
  JunitSuite suite{"images", "tests/m.toml", "tests/m.toml", "2026-11-02T10:15:30Z", 12.5, {}};
  suite.cases.push_back({"good", Outcome::passed, "", "", 0.25, {{"rmse", "0.5"}}});
  suite.cases.push_back({"bad", Outcome::failed, "rmse 0.5 (<= 0.1)", "line 1\nline 2", 1e-7, {}});
  suite.cases.push_back({"odd", Outcome::error, "out of memory", "", 0.0, {}});
  suite.cases.push_back({"left", Outcome::skipped, "not today", "", 0.0, {}});
  return suite;
}

TEST(Junit, Document_ParsesBack) {
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(to_junit(example()).c_str()));
  for (const pugi::xml_node node :
       {document.child("testsuites"), document.child("testsuites").child("testsuite")}) {
    EXPECT_EQ(node.attribute("tests").as_int(), 4);
    EXPECT_EQ(node.attribute("failures").as_int(), 1);
    EXPECT_EQ(node.attribute("errors").as_int(), 1);
    EXPECT_EQ(node.attribute("skipped").as_int(), 1);
    EXPECT_STREQ(node.attribute("time").value(), "12.500");
  }
  const pugi::xml_node suite = document.child("testsuites").child("testsuite");
  EXPECT_STREQ(suite.attribute("timestamp").value(), "2026-11-02T10:15:30Z");
  const auto find = [&](const char* name) {
    return suite.find_child_by_attribute("testcase", "name", name);
  };
  EXPECT_STREQ(find("good").attribute("classname").value(), "tests/m.toml");
  EXPECT_STREQ(find("good").attribute("time").value(), "0.250");
  const pugi::xml_node property = find("good").child("properties").child("property");
  EXPECT_STREQ(property.attribute("name").value(), "rmse");
  EXPECT_STREQ(property.attribute("value").value(), "0.5");
  EXPECT_FALSE(find("good").child("failure"));
  EXPECT_STREQ(find("bad").child("failure").attribute("message").value(), "rmse 0.5 (<= 0.1)");
  EXPECT_STREQ(find("bad").child("failure").text().get(), "line 1\nline 2");
  EXPECT_STREQ(find("bad").attribute("time").value(), "0.000");
  EXPECT_STREQ(find("odd").child("error").attribute("message").value(), "out of memory");
  EXPECT_STREQ(find("left").child("skipped").attribute("message").value(), "not today");
}

TEST(Junit, HostileTexts_StayTexts) {
  JunitSuite suite;
  const std::string hostile = "</testcase>&\"<x>\x1b[31m\xff\xc0\xaf\xed\xa0\x80\xef\xbf\xbf";
  suite.cases.push_back({hostile, Outcome::failed, hostile, hostile + "]]>", 0.0, {}});
  suite.cases.push_back({"Grüße \xf0\x9f\x8e\xa8 \xed\x9f\xbf", Outcome::passed, "", "", 0.0, {}});
  const std::string text = to_junit(suite);
  for (const unsigned char c : text) EXPECT_TRUE(c >= 0x20 || c == '\n') << static_cast<int>(c);
  EXPECT_THAT(text, Not(HasSubstr("\xff")));
  EXPECT_THAT(text, Not(HasSubstr("&#27;")));

  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(text.c_str()));
  const pugi::xml_node first = document.child("testsuites").child("testsuite").first_child();
  const std::string replaced = "\xef\xbf\xbd";
  std::string expected = "</testcase>&\"<x>" + replaced + "[31m";
  for (int i = 0; i < 9; ++i) expected += replaced;  // each byte that does not belong
  EXPECT_EQ(first.attribute("name").value(), expected);
  EXPECT_EQ(first.child("failure").text().get(), expected + "]]>");
  EXPECT_STREQ(first.next_sibling().attribute("name").value(),
               "Grüße \xf0\x9f\x8e\xa8 \xed\x9f\xbf");
}

}  // namespace
}  // namespace lume::io
