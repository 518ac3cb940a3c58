// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/test_update.h"

#include "io/compare/pixel_hash.h"
#include "renderer/cli/comparison_words.h"
#include "renderer/cli/test_case.h"
#include "renderer/cli/test_image.h"
#include "renderer/cli/test_judge.h"
#include "renderer/cli/text.h"
#include "renderer/cli/whole_file.h"

#include <fmt/format.h>

#include <exception>
#include <set>
#include <system_error>

namespace lume::cli {
namespace {

namespace fs = std::filesystem;

/// The metrics as they were before the reference changed.
std::string describe_change(const CaseResult& result) {
  std::string text;
  for (const io::MetricVerdict& metric : result.metrics) {
    text += (text.empty() ? "" : ", ") + metric.name + " " + metric_value(metric.value);
  }
  // Without metrics, what kept the images from being compared says more.
  return text.empty() ? result.message : text;
}

bool wants_update(const CaseResult& result, ReferenceUpdate mode) {
  if (result.verdict == CaseVerdict::missing) return true;
  // What was not made, or is not to be trusted, is no reference.
  if (result.pixels.empty()) return false;
  if (result.verdict == CaseVerdict::failed) return mode != ReferenceUpdate::missing;
  return result.verdict == CaseVerdict::passed && mode == ReferenceUpdate::all && !result.identical;
}

/// The file that is to be the reference: the image itself, but a stack of other seeds.
fs::path new_reference(const CaseResult& result, const std::atomic<bool>& cancel) {
  const io::TestCase& test = result.planned->test;
  const bool is_file = !result.planned->is_render() && test.command.empty();
  if (test.tier != io::Tier::statistical || is_file) return result.actual;
  return make_image(*result.planned, "reference", k_reference_seeds, cancel);
}

bool has_pixels_of(const fs::path& file, const fs::path& other) {
  std::error_code ignored;
  return fs::exists(other, ignored) &&
         io::pixel_hash(io::read_channels(file)) == io::pixel_hash(io::read_channels(other));
}

void leave(CaseResult& result) {
  const fs::path& reference = result.planned->test.reference;
  std::error_code ignored;
  result.update = fmt::format("{}: {}", fs::exists(reference, ignored) ? "unchanged" : "not made",
                              printable(reference.string()));
  if (is_failure(result.verdict))
    result.update += fmt::format(" ({})", verdict_name(result.verdict));
}

void accept(CaseResult& result, const std::atomic<bool>& cancel) {
  const fs::path& reference = result.planned->test.reference;
  const bool is_new = result.verdict == CaseVerdict::missing;
  const std::string change = is_new ? "" : describe_change(result);
  const fs::path file = new_reference(result, cancel);
  const bool is_same = !is_new && has_pixels_of(file, reference);
  if (!is_same) {
    if (reference.has_parent_path()) make_folder(reference.parent_path());
    copy_whole(file, reference);
  }
  std::error_code ignored;
  if (file != result.actual) fs::remove(file, ignored);
  if (is_same) return leave(result);
  result.update = fmt::format("{}: {}{}", is_new ? "new" : "changed", printable(reference.string()),
                              change.empty() ? "" : " (it was: " + change + ")");
  judge_again(result);
  if (result.verdict != CaseVerdict::passed) return;  // even its own reference does not suit it
  result.verdict = CaseVerdict::accepted;
  result.message = is_new ? "a new reference" : "the reference has changed";
}

void update_one(CaseResult& result, ReferenceUpdate mode, bool is_written,
                const std::atomic<bool>& cancel) {
  if (is_written && !result.pixels.empty() && result.verdict != CaseVerdict::flaky) {
    judge_again(result);
  } else if (wants_update(result, mode)) {
    accept(result, cancel);
  } else {
    leave(result);
  }
}

}  // namespace

void update_references(TestRun& run, const std::atomic<bool>& cancel) {
  if (run.options.update == ReferenceUpdate::none) return;
  std::set<fs::path> written;
  for (CaseResult& result : run.results) {
    if (cancel) return;
    if (result.verdict == CaseVerdict::skipped || result.verdict == CaseVerdict::not_run) continue;
    const fs::path reference = result.planned->test.reference.lexically_normal();
    try {
      update_one(result, run.options.update, written.contains(reference), cancel);
    } catch (const std::exception& error) {
      result.verdict = CaseVerdict::failed;
      result.message = printable(error.what());
    }
    if (result.verdict == CaseVerdict::accepted) written.insert(reference);
  }
}

}  // namespace lume::cli
