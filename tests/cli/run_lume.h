// SPDX-License-Identifier: Apache-2.0
// Runs the program as a user would.
#pragma once

#include "tests/support/paths.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace lume::cli {

inline std::string read_text(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

struct Outcome {
  int exit_code = -1;  ///< -1: ended by a signal
  std::string out;
  std::string err;
};

/// A `lume` at work in `folder`, where it leaves what it says.
class LumeProcess {
 public:
  LumeProcess(const std::filesystem::path& folder, std::vector<std::string> arguments)
      : out_(folder / "stdout.txt"), err_(folder / "stderr.txt") {
    arguments.insert(arguments.begin(), LUME_PROGRAM);
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    std::filesystem::remove(err_);  // wait_for() must not see what an earlier process said
    process_ = fork();
    if (process_ != 0) return;
    redirect(out_, STDOUT_FILENO);
    redirect(err_, STDERR_FILENO);
    if (chdir(folder.c_str()) == 0) execv(argv[0], argv.data());
    _exit(127);
  }
  LumeProcess(const LumeProcess&) = delete;
  LumeProcess& operator=(const LumeProcess&) = delete;
  ~LumeProcess() {
    if (process_ <= 0) return;
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }

  /// Waits until the text appears on stderr; false if that does not happen within a minute.
  [[nodiscard]] bool wait_for(const std::string& text) const {
    for (int i = 0; i < 6000; ++i) {
      if (read_text(err_).find(text) != std::string::npos) return true;
      usleep(10000);
    }
    return false;
  }
  void send(int signal) const { kill(process_, signal); }

  Outcome wait() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out_), read_text(err_)};
  }

 private:
  static void redirect(const std::filesystem::path& path, int descriptor) {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (file < 0 || dup2(file, descriptor) < 0) _exit(126);
  }

  std::filesystem::path out_;
  std::filesystem::path err_;
  pid_t process_ = -1;
};

inline Outcome run_lume(const tests::TemporaryFolder& folder, std::vector<std::string> arguments) {
  return LumeProcess(folder.path(), std::move(arguments)).wait();
}

}  // namespace lume::cli
