// SPDX-License-Identifier: Apache-2.0
// The one parallel loop. It hides oneTBB so that a plain std::thread backend can take its place
// under ThreadSanitizer, which Debian's uninstrumented TBB blinds (LUME_STD_THREADS).
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>

namespace lume::geometry {

/// While alive, limits all of Lume, Embree included, to `threads` threads (0: one per core).
class ThreadLimit {
 public:
  explicit ThreadLimit(unsigned threads);
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;
  ~ThreadLimit();
  [[nodiscard]] unsigned threads() const { return threads_; }

 private:
  unsigned threads_;
  std::shared_ptr<void> control_;
};

/// Calls body(i) once for every i < count, on several threads, in no particular order. When *cancel
/// turns true, bodies that have not begun are left out. Of bodies that throw, the exception of the
/// lowest i is thrown here, and bodies above it may have been left out.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body,
                  const std::atomic<bool>* cancel = nullptr);

}  // namespace lume::geometry
