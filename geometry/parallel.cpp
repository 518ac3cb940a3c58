// SPDX-License-Identifier: Apache-2.0
#include "geometry/parallel.h"

#include <algorithm>
#include <exception>
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

}  // namespace

#ifdef LUME_STD_THREADS

ThreadLimit::ThreadLimit(unsigned threads) : threads_(threads == 0 ? core_count() : threads) {
  g_threads = threads_;
}

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body,
                  const std::atomic<bool>* cancel) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < count && !is_cancelled(cancel); i = next++) {
      try {
        body(i);
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> others;
  for (unsigned i = 1; i < g_threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
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
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i != range.end() && !is_cancelled(cancel); ++i) {
            body(i);
          }
        },
        tbb::simple_partitioner{});
  });
}

#endif

ThreadLimit::~ThreadLimit() { g_threads = core_count(); }

}  // namespace lume::geometry
