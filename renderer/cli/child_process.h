// SPDX-License-Identifier: Apache-2.0
// Another program, started without a shell and not waited for longer than is sensible.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

namespace lume::cli {

/// Runs a program in `folder` (where a relative path in its name starts, too; a name without a
/// slash is looked for in PATH), with nothing to read and all that it says in the file `log`. It
/// has a process group of its own, which is killed once `timeout` seconds are over or `cancel`
/// turns true. Returns why it is no success ("ended with exit code 3"); empty if it is one.
[[nodiscard]] std::string run_child(std::vector<std::string> words,
                                    const std::filesystem::path& folder,
                                    const std::filesystem::path& log, double timeout,
                                    const std::atomic<bool>& cancel);

}  // namespace lume::cli
