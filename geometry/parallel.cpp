// SPDX-License-Identifier: Apache-2.0
#include "geometry/parallel.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <vector>

#ifndef LUME_STD_THREADS
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace lume::geometry {
namespace {

unsigned core_count() { return std::max(1u, std::thread::hardware_concurrency()); }

/// Written by ThreadLimit only, while no loop runs.
unsigned g_threads = core_count();  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

bool is_cancelled(const std::atomic<bool>* cancel) {
  return cancel != nullptr && cancel->load(std::memory_order_relaxed);
}

/// The exception of the lowest index that throws. Bodies below it still run, since one of them may
/// throw as well: so it is the same one however threads take turns.
class FirstFailure {
 public:
  void run(std::size_t i, const std::function<void(std::size_t)>& body) {
    if (i > index_.load(std::memory_order_relaxed)) return;
    try {
      body(i);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (i >= index_) return;
      index_ = i;
      exception_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::atomic<std::size_t> index_{std::numeric_limits<std::size_t>::max()};
  std::mutex mutex_;
  std::exception_ptr exception_;
};

}  // namespace

#ifdef LUME_STD_THREADS

ThreadLimit::ThreadLimit(unsigned threads) : threads_(threads == 0 ? core_count() : threads) {
  g_threads = threads_;
}

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body,
                  const std::atomic<bool>* cancel) {
  std::atomic<std::size_t> next{0};
  FirstFailure failure;
  const auto work = [&] {
    for (std::size_t i = next++; i < count && !is_cancelled(cancel); i = next++) {
      failure.run(i, body);
    }
  };
  std::vector<std::thread> others;
  for (unsigned i = 1; i < g_threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  failure.rethrow();
}

#else

ThreadLimit::ThreadLimit(unsigned threads)
    : threads_(threads == 0 ? core_count() : threads),
      control_(std::make_shared<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                     threads_)) {
  g_threads = threads_;
}

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body,
                  const std::atomic<bool>* cancel) {
  // An arena of its own, because the default one has a slot per core however many threads are
  // asked.
  tbb::task_arena arena(static_cast<int>(g_threads));
  FirstFailure failure;
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i != range.end() && !is_cancelled(cancel); ++i) {
            failure.run(i, body);
          }
        },
        tbb::simple_partitioner{});
  });
  failure.rethrow();
}

#endif

ThreadLimit::~ThreadLimit() { g_threads = core_count(); }

}  // namespace lume::geometry
