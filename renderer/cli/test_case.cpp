// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/test_case.h"

#include "io/compare/pixel_hash.h"
#include "renderer/cli/render_stats.h"
#include "renderer/cli/test_image.h"
#include "renderer/cli/test_judge.h"
#include "renderer/cli/test_pictures.h"
#include "renderer/cli/text.h"
#include "renderer/cli/whole_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

namespace lume::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_shown_log_lines = 10;

void fail(CaseResult& result, const std::string& why) {
  result.verdict = CaseVerdict::failed;
  result.message = printable(why);
}

void say_missing(CaseResult& result) {
  result.verdict = CaseVerdict::missing;
  result.message = printable(fmt::format("there is no {}; look at {}, and if it is right: {}",
                                         result.planned->test.reference.string(),
                                         result.actual.string(), result.planned->accept_command));
}

void judge_actual(CaseResult& result) {
  const io::TestCase& test = result.planned->test;
  const io::ImageFile actual = io::read_channels(result.actual);
  result.pixels = io::pixel_hash(actual);
  result.expected.clear();
  result.difference.clear();
  std::error_code ignored;
  if (!fs::exists(test.reference, ignored)) return say_missing(result);
  result.expected = result.planned->picture("expected");
  copy_whole(test.reference, result.expected);
  Judgement judgement = judge(test, actual, io::read_channels(test.reference));
  result.verdict = judgement.passed ? CaseVerdict::passed : CaseVerdict::failed;
  result.identical = judgement.identical;
  result.message = printable(judgement.message);
  result.metrics = std::move(judgement.metrics);
  result.color_image = judgement.color_image;
  if (!judgement.flip_map.empty() && !judgement.identical) {
    result.difference = result.planned->folder / "difference.png";
    const shading::PixelRegion& region = actual.images[judgement.color_image].region;
    write_flip_map(result.difference, judgement.flip_map, region.width, region.height);
    result.flip_map = std::move(judgement.flip_map);
  }
}

/// Of an earlier run.
void clear_folder(const PlannedCase& planned) {
  make_folder(planned.folder);
  std::error_code ignored;
  for (const fs::path& file : {planned.picture("actual"), planned.picture("expected"),
                               planned.folder / "difference.png", planned.folder / "log.txt"}) {
    fs::remove(file, ignored);
  }
}

CaseResult attempt(const PlannedCase& planned, const std::atomic<bool>& cancel) {
  CaseResult result;
  result.planned = &planned;
  try {
    clear_folder(planned);
    result.actual = make_image(planned, "actual", 0, cancel);
    judge_actual(result);
  } catch (const std::bad_alloc&) {
    fail(result, "out of memory");
  } catch (const std::exception& error) {
    if (cancel) {
      result.verdict = CaseVerdict::not_run;
      return result;
    }
    fail(result, error.what());
    result.log = last_lines(planned.folder / "log.txt", k_shown_log_lines);
  }
  return result;
}

/// How one attempt differs from the first; empty if it does not.
std::string unlike(const CaseResult& first, const CaseResult& other) {
  if (first.verdict != other.verdict) {
    return fmt::format("the first {}, this one {}", verdict_name(first.verdict),
                       verdict_name(other.verdict));
  }
  return first.pixels != other.pixels ? "the pixels are not equal" : "";
}

}  // namespace

CaseResult run_case(const PlannedCase& planned, unsigned repeat, const std::atomic<bool>& cancel) {
  const Stopwatch watch;
  CaseResult result;
  result.planned = &planned;
  if (!planned.test.skip.empty()) {
    result.verdict = CaseVerdict::skipped;
    result.message = printable(planned.test.skip);
    return result;
  }
  result = attempt(planned, cancel);
  for (unsigned i = 2; i <= repeat && result.verdict != CaseVerdict::not_run; ++i) {
    CaseResult other = attempt(planned, cancel);
    if (other.verdict == CaseVerdict::not_run) break;
    const std::string difference = unlike(result, other);
    if (difference.empty()) continue;
    const bool both_say = result.verdict == other.verdict;
    const std::string why = other.message.empty() ? result.message : other.message;
    result = std::move(other);
    result.verdict = CaseVerdict::flaky;
    result.message = fmt::format("run {} of {} differs from the first: {}{}", i, repeat, difference,
                                 both_say || why.empty() ? "" : " (" + why + ")");
    break;
  }
  result.seconds = watch.elapsed();
  return result;
}

void judge_again(CaseResult& result) {
  try {
    judge_actual(result);
  } catch (const std::exception& error) {
    fail(result, error.what());
  }
}

std::vector<CaseResult> run_cases(const std::vector<PlannedCase>& plan, unsigned jobs,
                                  unsigned repeat, const std::atomic<bool>& cancel,
                                  const std::function<void(const CaseResult&)>& on_done) {
  std::vector<CaseResult> results(plan.size());
  std::vector<char> done(plan.size(), 0);
  std::atomic<std::size_t> next{0};
  std::size_t told = 0;
  std::mutex mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < plan.size(); i = next++) {
      results[i].planned = &plan[i];
      if (!cancel) results[i] = run_case(plan[i], repeat, cancel);
      const std::lock_guard lock(mutex);
      done[i] = 1;
      for (; told < plan.size() && done[told] != 0; ++told) on_done(results[told]);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < std::min<std::size_t>(jobs, plan.size()); ++i) {
    threads.emplace_back(work);
  }
  work();
  for (std::thread& thread : threads) thread.join();
  return results;
}

}  // namespace lume::cli
