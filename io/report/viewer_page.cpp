// SPDX-License-Identifier: Apache-2.0
#include "io/report/viewer_page.h"

#include "io/report/packed_image.h"
#include "io/report/page_template.h"
#include "io/report/reduced_image.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace lume::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr SizeLimit k_single_case{8192, std::size_t{4096} * 2304};
constexpr int k_longest_side = 2048;
constexpr std::size_t k_many_cases_pixels = 12'000'000;
/// Of pictures for which there is no room left.
constexpr int k_preview_side = 256;

std::string_view to_text(PageVerdict verdict) {
  switch (verdict) {
    case PageVerdict::failed:
      return "failed";
    case PageVerdict::refused:
      return "refused";
    case PageVerdict::missing_reference:
      return "missing reference";
    case PageVerdict::skipped:
      return "skipped";
    case PageVerdict::passed:
      return "passed";
  }
  return "";
}

bool is_there(const std::optional<PageImage>& image) {
  return image && !image->image.pixels.empty();
}

/// Valid JSON that a script element cannot take for its end, whatever the texts are.
std::string to_script_text(const Json& json) {
  std::string text;
  // Names need not be UTF-8, JSON must be.
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<') {
      text += "\\u003c";
    } else if (c == '>') {
      text += "\\u003e";
    } else {
      text += c;
    }
  }
  return text;
}

/// Writes cases one after the other, and knows how much room there is for the next.
class CaseWriter {
 public:
  explicit CaseWriter(bool single) : single_(single) {}

  Json write(const PageCase& page_case);
  /// The elements of script that hold the pictures.
  std::string take_data() { return std::move(data_); }

 private:
  int choose_reduction(const PageCase& page_case);
  Json write_image(const PageImage& image, int factor);
  Json write_map(const PageCase& page_case, int factor);
  Json write_packed(const PackedImage& packed);

  bool single_;
  std::size_t room_ = k_many_cases_pixels;
  int pictures_ = 0;
  std::string data_;
};

int CaseWriter::choose_reduction(const PageCase& page_case) {
  const auto factor_for = [&](const SizeLimit& limit) {
    int factor = 1;
    for (const auto* image : {&page_case.actual, &page_case.expected}) {
      if (!is_there(*image)) continue;
      factor =
          std::max(factor, reduction_factor((*image)->image.width, (*image)->image.height, limit));
    }
    return factor;
  };
  if (single_) return factor_for(k_single_case);
  const int factor = factor_for({k_longest_side, k_many_cases_pixels});
  std::size_t pixels = 0;
  for (const auto* image : {&page_case.actual, &page_case.expected}) {
    if (is_there(*image)) pixels += (*image)->image.pixels.size();
  }
  pixels /= static_cast<std::size_t>(factor) * static_cast<std::size_t>(factor);
  if (pixels > room_) return factor_for({k_preview_side, k_many_cases_pixels});
  room_ -= pixels;
  return factor;
}

Json CaseWriter::write_packed(const PackedImage& packed) {
  const std::string id = fmt::format("picture{}", ++pictures_);
  data_ += fmt::format(R"(<script type="text/plain" id="{}">)", id);
  data_ += packed.data;
  data_ += "</script>\n";
  return {{"width", packed.width},
          {"height", packed.height},
          {"format", packed.format},
          {"rounded", packed.rounded},
          {"data", id}};
}

Json CaseWriter::write_image(const PageImage& image, int factor) {
  const RgbImage reduced = factor > 1 ? reduce(image.image, factor) : RgbImage{};
  const RgbImage& shown = factor > 1 ? reduced : image.image;
  Json json = write_packed(image.display_referred ? pack_display_referred(shown)
                                                  : pack_scene_linear(shown));
  json["label"] = image.label;
  json["fullWidth"] = image.image.width;
  json["fullHeight"] = image.image.height;
  return json;
}

Json CaseWriter::write_map(const PageCase& page_case, int factor) {
  const RgbImage& like = page_case.actual->image;
  if (factor == 1) return write_packed(pack_map(page_case.flip_map, like.width, like.height));
  const std::vector<float> reduced = reduce(page_case.flip_map, like.width, like.height, factor);
  return write_packed(
      pack_map(reduced, (like.width + factor - 1) / factor, (like.height + factor - 1) / factor));
}

Json CaseWriter::write(const PageCase& page_case) {
  const int factor = choose_reduction(page_case);
  Json json = {{"name", page_case.name},       {"verdict", to_text(page_case.verdict)},
               {"message", page_case.message}, {"accept", page_case.accept_command},
               {"history", page_case.history}, {"reduction", factor},
               {"facts", Json::array()}};
  if (page_case.seconds) json["seconds"] = *page_case.seconds;
  for (const PageFact& fact : page_case.facts) {
    json["facts"].push_back({{"name", fact.name},
                             {"value", fact.value},
                             {"limit", fact.limit},
                             {"failed", fact.failed}});
  }
  if (is_there(page_case.actual)) {
    json["actual"] = write_image(*page_case.actual, factor);
    if (page_case.flip_map.size() == page_case.actual->image.pixels.size()) {
      json["flip"] = write_map(page_case, factor);
    }
  }
  if (is_there(page_case.expected)) json["expected"] = write_image(*page_case.expected, factor);
  return json;
}

/// For those who read without scripts.
std::string plain_list(const std::vector<const PageCase*>& cases) {
  std::string list;
  for (const PageCase* page_case : cases) {
    list += fmt::format("<li>{}: {} {}</li>\n", html_text(page_case->name),
                        to_text(page_case->verdict), html_text(page_case->message));
  }
  return list;
}

}  // namespace

std::string to_html(const ReportPage& report) {
  std::vector<const PageCase*> cases;
  cases.reserve(report.cases.size());
  for (const PageCase& page_case : report.cases) cases.push_back(&page_case);
  std::stable_sort(cases.begin(), cases.end(),
                   [](const PageCase* a, const PageCase* b) { return a->verdict < b->verdict; });

  CaseWriter writer(cases.size() == 1);
  Json json = {{"title", report.title},
               {"command", report.command},
               {"summary", report.summary},
               {"cases", Json::array()}};
  for (const PageCase* page_case : cases) json["cases"].push_back(writer.write(*page_case));
  return fill_page({{"title", html_text(report.title)},
                    {"command", html_text(report.command)},
                    {"summary", html_text(report.summary)},
                    {"plain-list", plain_list(cases)},
                    {"report", to_script_text(json)},
                    {"pictures", writer.take_data()}});
}

}  // namespace lume::io
