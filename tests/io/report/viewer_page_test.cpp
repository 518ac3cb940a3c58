// SPDX-License-Identifier: Apache-2.0
// What is in the pages; what they do is tested in tests/browser.
#include "io/report/viewer_page.h"
#include "tests/io/report/packed_pages.h"

#include <gmock/gmock.h>

#include <regex>

namespace lume::io {
namespace {

using shading::Color;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* k_hostile =
    "</script><!--<script>x=1</script>--> ]]> \" ' & {{script}} \xFF \x01 \xE2\x80\xA8";

PageImage flat_image(int width, int height, float value) {
  RgbImage image{width, height, {}};
  image.pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                      Color(value));
  return {"flat.exr", std::move(image), false};
}

PageCase named_case(const std::string& name, PageVerdict verdict = PageVerdict::passed) {
  PageCase page_case;
  page_case.name = name;
  page_case.verdict = verdict;
  return page_case;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
    ++found;
  }
  return found;
}

TEST(ViewerPage, HostileTexts_AreTextsOnly) {
  PageCase hostile = named_case(k_hostile, PageVerdict::failed);
  hostile.message = hostile.accept_command = hostile.history = k_hostile;
  hostile.facts = {{k_hostile, k_hostile, k_hostile, true}};
  hostile.actual = flat_image(2, 2, 0.5f);
  hostile.actual->label = k_hostile;
  const std::string page = to_html({k_hostile, k_hostile, k_hostile, {hostile}});

  PageCase plain = named_case("plain", PageVerdict::failed);
  plain.message = plain.accept_command = plain.history = "plain";
  plain.facts = {{"plain", "plain", "plain", true}};
  plain.actual = flat_image(2, 2, 0.5f);
  const std::string harmless = to_html({"plain", "plain", "plain", {plain}});

  for (const char* markup : {"<script", "</script", "<!--", "-->", "<"}) {
    EXPECT_EQ(count(page, markup), count(harmless, markup)) << markup;
  }
  const nlohmann::json json = test::report_of(page);
  EXPECT_THAT(json["cases"][0]["name"].get<std::string>(),
              HasSubstr("</script><!--<script>x=1</script>--> ]]> \" ' & {{script}} \xEF\xBF\xBD"));
  EXPECT_EQ(json["title"], json["cases"][0]["facts"][0]["limit"]);
}

TEST(ViewerPage, Pictures_AreThereWithTheirValues) {
  PageCase page_case = named_case("a");
  page_case.actual = flat_image(4, 3, 0.0f);
  for (std::size_t i = 0; i < 12; ++i) {
    page_case.actual->image.pixels[i] = Color(static_cast<float>(i), 0.25f, -0.5f);
  }
  page_case.expected = flat_image(4, 3, 1.0f);
  page_case.flip_map.assign(12, 1.0f);
  const std::string page = to_html({"t", "c", "s", {page_case}});
  const nlohmann::json json = test::report_of(page)["cases"][0];
  const auto data = [&](const char* side) { return test::script_text(page, json[side]["data"]); };
  const auto actual = test::unpack(data("actual"), 4, 3, 3, 2);
  const auto expected = test::unpack(data("expected"), 4, 3, 3, 2);
  const auto flip = test::unpack(data("flip"), 4, 3, 1, 1);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(test::half_value(actual[0][i]), static_cast<float>(i));
    EXPECT_EQ(test::half_value(actual[1][i]), 0.25f);
    EXPECT_EQ(test::half_value(actual[2][i]), -0.5f);
    EXPECT_EQ(test::half_value(expected[1][i]), 1.0f);
    EXPECT_EQ(flip[0][i], 255u);
  }
}

TEST(ViewerPage, Cases_AreListedFailuresFirstInGivenOrder) {
  const std::string page = to_html(
      {"t",
       "c",
       "s",
       {named_case("p1"), named_case("s", PageVerdict::skipped), named_case("p2"),
        named_case("f1", PageVerdict::failed), named_case("m", PageVerdict::missing_reference),
        named_case("r", PageVerdict::refused), named_case("f2", PageVerdict::failed)}});
  std::vector<std::string> names;
  const nlohmann::json json = test::report_of(page);
  for (const auto& page_case : json["cases"]) names.push_back(page_case["name"]);
  EXPECT_EQ(names, (std::vector<std::string>{"f1", "f2", "r", "m", "s", "p1", "p2"}));
}

TEST(ViewerPage, SameReport_GivesTheSameBytes) {
  PageCase page_case = named_case("a");
  page_case.actual = flat_image(30, 20, 0.3f);
  page_case.seconds = 0.1;
  const ReportPage report{"t", "c", "s", {page_case, named_case("b")}};
  EXPECT_EQ(to_html(report), to_html(report));
}

TEST(ViewerPage, LargePicturesOfManyCases_AreReduced) {
  PageCase large = named_case("large", PageVerdict::failed);
  large.actual = flat_image(2049, 3, 0.5f);
  large.flip_map.assign(large.actual->image.pixels.size(), 0.5f);
  const nlohmann::json one = test::report_of(to_html({"t", "c", "s", {large}}))["cases"][0];
  EXPECT_EQ(one["reduction"], 1);
  EXPECT_EQ(one["actual"]["width"], 2049);
  const std::string page = to_html({"t", "c", "s", {large, named_case("b")}});
  const nlohmann::json many = test::report_of(page)["cases"][0];
  EXPECT_EQ(many["reduction"], 2);
  for (const char* side : {"actual", "flip"}) {
    EXPECT_EQ(many[side]["width"], 1025);
    EXPECT_EQ(many[side]["height"], 2);
  }
  EXPECT_EQ(many["actual"]["fullWidth"], 2049);
  const auto codes = test::unpack(test::script_text(page, many["actual"]["data"]), 1025, 2, 3, 2);
  EXPECT_EQ(test::half_value(codes[0][2049]), 0.5f);
}

TEST(ViewerPage, PicturesWithoutRoom_AreReducedButTheFirst) {
  ReportPage report{"t", "c", "s", {}};
  for (int i = 0; i < 3; ++i) {
    report.cases.push_back(named_case(std::to_string(i)));
    report.cases.back().actual = flat_image(2048, 2000, 0.5f);
  }
  report.cases.back().verdict = PageVerdict::failed;
  const nlohmann::json cases = test::report_of(to_html(report))["cases"];
  EXPECT_EQ(cases[0]["name"], "2");
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(cases[i]["reduction"], i < 2 ? 1 : 8) << i;
}

TEST(ViewerPage, Page_NeedsNothingFromElsewhere) {
  const std::string page = to_html({"t", "c", "s", {named_case("a")}});
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_FALSE(std::regex_search(page, std::regex(R"((src|href)=["']?(https?:|//))")));
  EXPECT_THAT(page, Not(HasSubstr("{{")));
  EXPECT_EQ(count(page, "<script"), count(page, "</script>"));
}

TEST(ViewerPage, CaseWithoutPicture_HasNone) {
  PageCase page_case = named_case("a", PageVerdict::skipped);
  page_case.expected = PageImage{};
  page_case.flip_map.assign(4, 1.0f);
  const nlohmann::json json = test::report_of(to_html({"t", "c", "s", {page_case}}))["cases"][0];
  for (const char* side : {"actual", "expected", "flip"}) EXPECT_FALSE(json.contains(side)) << side;
}

}  // namespace
}  // namespace lume::io
