// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>

#include <atomic>

namespace lume::cli {

/// While alive, the first SIGINT or SIGTERM only raises a flag, so that what is done can be
/// written; the second ends the process at once with exit code 130. One at a time.
class InterruptGuard {
 public:
  /// `announce`: say on stderr that a second signal ends at once.
  explicit InterruptGuard(bool announce);
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  ~InterruptGuard();

  [[nodiscard]] static const std::atomic<bool>& flag();

 private:
  struct sigaction old_interrupt_ {};
  struct sigaction old_terminate_ {};
};

}  // namespace lume::cli
