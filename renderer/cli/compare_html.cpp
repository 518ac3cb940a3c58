// SPDX-License-Identifier: Apache-2.0
#include "io/report/viewer_page.h"
#include "renderer/cli/compare_report.h"
#include "renderer/cli/comparison_words.h"
#include "renderer/cli/text.h"

#include <utility>

namespace lume::cli {
namespace {

io::PageVerdict page_verdict(const CompareDocument& document) {
  if (document.comparison.refusal != io::Refusal::none) return io::PageVerdict::refused;
  return document.passed() ? io::PageVerdict::passed : io::PageVerdict::failed;
}

io::PageImage page_image(const io::ImageFile& file, std::size_t index) {
  const io::ChannelImage& image = file.images[index < file.images.size() ? index : 0];
  return {file.path, io::color_of(image), image.display_referred};
}

}  // namespace

std::string compare_to_html(const CompareDocument& document) {
  const io::Comparison& comparison = document.comparison;
  io::PageCase page;
  page.name = document.actual.path;
  page.verdict = page_verdict(document);
  page.message = reason(document);
  for (const io::MetricVerdict& metric : comparison.verdicts) {
    page.facts.push_back(
        {metric.name, metric_value(metric.value), metric_limit(metric), metric.failed});
  }
  page.actual = page_image(document.actual, comparison.color_image);
  page.expected = page_image(document.expected, comparison.color_image);
  page.flip_map = comparison.flip_map;
  std::string command = "lume compare";
  for (const std::string& argument : document.options.arguments) {
    command += " " + shell_quote(argument);
  }
  return io::to_html({"lume compare", std::move(command), verdict(document), {std::move(page)}});
}

}  // namespace lume::cli
