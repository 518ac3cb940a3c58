// SPDX-License-Identifier: Apache-2.0
#include "io/image_tests/stack_file.h"
#include "io/report/viewer_page.h"
#include "renderer/cli/comparison_words.h"
#include "renderer/cli/test_judge.h"
#include "renderer/cli/test_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace lume::cli {
namespace {

/// Pixels of all pictures together that are held in memory for the page; 12 bytes each.
constexpr std::size_t k_most_pixels = std::size_t{1} << 26u;

io::PageVerdict page_verdict(CaseVerdict verdict) {
  switch (verdict) {
    case CaseVerdict::passed:
    case CaseVerdict::accepted:
      return io::PageVerdict::passed;
    case CaseVerdict::missing:
      return io::PageVerdict::missing_reference;
    case CaseVerdict::skipped:
    case CaseVerdict::not_run:
      return io::PageVerdict::skipped;
    case CaseVerdict::failed:
    case CaseVerdict::flaky:
      break;
  }
  return io::PageVerdict::failed;
}

/// The file's picture, the mean of a stack; absent if it cannot be shown or there is no room left.
std::optional<io::PageImage> page_image(const CaseResult& result, const std::filesystem::path& file,
                                        std::size_t& room) {
  if (file.empty()) return std::nullopt;
  const bool is_stack = result.planned->test.tier == io::Tier::statistical;
  try {
    const io::ImageFile images = io::read_channels(file);
    const io::ChannelImage image =
        is_stack ? io::mean_of(images) : images.images.at(result.color_image);
    const auto pixels = static_cast<std::size_t>(image.region.width) *
                        static_cast<std::size_t>(image.region.height);
    if (pixels > room) return std::nullopt;
    room -= pixels;
    return io::PageImage{file.string(), io::color_of(image), image.display_referred};
  } catch (const std::exception&) {
    return std::nullopt;  // what is wrong with it is the case's message
  }
}

std::vector<io::PageFact> page_facts(const CaseResult& result) {
  std::vector<io::PageFact> facts;
  facts.reserve(result.metrics.size());
  for (const io::MetricVerdict& metric : result.metrics) {
    facts.push_back({metric.name, metric_value(metric.value), metric_limit(metric), metric.failed});
  }
  return facts;
}

io::PageCase page_case(const CaseResult& result, std::size_t& room) {
  const io::TestCase& test = result.planned->test;
  io::PageCase page;
  page.name = test.name;
  page.verdict = page_verdict(result.verdict);
  page.message = result.message;
  if (result.verdict == CaseVerdict::flaky || result.verdict == CaseVerdict::not_run) {
    page.message = fmt::format("{}: {}", verdict_name(result.verdict), result.message);
  }
  for (const std::string& line : result.log) page.message += " | " + line;
  page.facts = page_facts(result);
  page.actual = page_image(result, result.actual, room);
  page.expected = page_image(result, result.expected, room);
  if (page.actual) page.flip_map = result.flip_map;
  if (is_failure(result.verdict) && !result.pixels.empty()) {
    page.accept_command = result.planned->accept_command;
  }
  if (result.verdict != CaseVerdict::skipped) page.seconds = result.seconds;
  page.history = describe_history(result.history);
  return page;
}

}  // namespace

std::string test_to_html(const TestRun& run) {
  io::ReportPage page{"lume test", test_command(run.options), summarize(run), {}};
  page.cases.resize(run.results.size());
  // Failures first: where there is no room for all pictures, theirs are wanted.
  std::vector<std::size_t> order(run.results.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(),
                        [&](std::size_t i) { return is_failure(run.results[i].verdict); });
  std::size_t room = k_most_pixels;
  for (const std::size_t i : order) page.cases[i] = page_case(run.results[i], room);
  return io::to_html(page);
}

}  // namespace lume::cli
