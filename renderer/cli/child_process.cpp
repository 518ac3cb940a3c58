// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/child_process.h"

#include "renderer/cli/text.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <system_error>
#include <thread>

namespace lume::cli {
namespace {

/// posix_spawn's attributes and actions, released at the end.
class SpawnSettings {
 public:
  SpawnSettings(const std::filesystem::path& folder, const std::filesystem::path& log) {
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_init(&actions_);
    sigset_t all;
    sigfillset(&all);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    // The log first: its path starts where this process is.
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, log.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0666);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }

  [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }
  [[nodiscard]] const posix_spawn_file_actions_t* actions() const { return &actions_; }

 private:
  posix_spawnattr_t attributes_{};
  posix_spawn_file_actions_t actions_{};
};

std::string describe_end(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    const char* name = sigabbrev_np(signal);
    return fmt::format("was ended by signal {} ({})", signal, name != nullptr ? name : "unknown");
  }
  const int code = WEXITSTATUS(status);
  return code == 0 ? "" : fmt::format("ended with exit code {}", code);
}

std::string wait_for(pid_t process, double timeout, const std::atomic<bool>& cancel) {
  using Clock = std::chrono::steady_clock;
  using std::chrono::milliseconds;
  const auto start = Clock::now();
  milliseconds pause(1);
  int status = 0;
  while (waitpid(process, &status, WNOHANG) == 0) {
    const bool late = std::chrono::duration<double>(Clock::now() - start).count() > timeout;
    if (late || cancel) {
      kill(-process, SIGKILL);
      waitpid(process, &status, 0);
      return late ? fmt::format("took longer than {} s and was ended (timeout = {})", timeout,
                                timeout)
                  : "was interrupted";
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, milliseconds(20));
  }
  return describe_end(status);
}

}  // namespace

std::string run_child(std::vector<std::string> words, const std::filesystem::path& folder,
                      const std::filesystem::path& log, double timeout,
                      const std::atomic<bool>& cancel) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  const SpawnSettings settings(folder, log);
  pid_t process = -1;
  const int error = posix_spawnp(&process, arguments.front(), settings.actions(),
                                 settings.attributes(), arguments.data(), environ);
  const std::string name = printable(words.front());
  if (error != 0) {
    return fmt::format("{} cannot be started: {}", name, std::generic_category().message(error));
  }
  const std::string end = wait_for(process, timeout, cancel);
  return end.empty() ? "" : name + " " + end;
}

}  // namespace lume::cli
