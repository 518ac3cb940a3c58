// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/interrupt.h"

#include "renderer/cli/exit_codes.h"

#include <unistd.h>

#include <cstring>

namespace lume::cli {
namespace {

std::atomic<bool> g_interrupted{false};
// What the handler says; null: nothing. Chosen before, since isatty() is not for signal handlers.
std::atomic<const char*> g_message{nullptr};
constexpr const char* k_message =
    "\nlume: stopping to write what is done; once more to quit at once\n";
// Only lock-free atomics may be touched by a signal handler ([support.signal]).
static_assert(std::atomic<bool>::is_always_lock_free);
static_assert(std::atomic<const char*>::is_always_lock_free);

extern "C" void handle_signal(int /*signal*/) {
  if (g_interrupted.exchange(true)) _exit(static_cast<int>(ExitCode::interrupted));
  const char* message = g_message;
  if (message == nullptr) return;
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message, std::strlen(message));
}

}  // namespace

InterruptGuard::InterruptGuard(bool announce) {
  g_interrupted = false;
  // On a terminal a progress bar may stand on the line.
  if (announce) g_message = isatty(STDERR_FILENO) == 1 ? k_message : k_message + 1;
  struct sigaction action {};
  action.sa_handler = handle_signal;
  // Without SA_RESTART a library's read() could fail with EINTR and spoil what is to be written.
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &old_interrupt_);
  sigaction(SIGTERM, &action, &old_terminate_);
}

InterruptGuard::~InterruptGuard() {
  sigaction(SIGINT, &old_interrupt_, nullptr);
  sigaction(SIGTERM, &old_terminate_, nullptr);
  g_message = nullptr;
}

const std::atomic<bool>& InterruptGuard::flag() { return g_interrupted; }

}  // namespace lume::cli
