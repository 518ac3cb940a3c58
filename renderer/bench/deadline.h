// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace lume::renderer {

/// A time after which to stop. The clock is read every few calls only.
class Deadline {
 public:
  explicit Deadline(double seconds) : seconds_(seconds) {}

  [[nodiscard]] bool is_over() {
    constexpr unsigned k_calls = 16;
    if (++calls_ % k_calls != 0) return false;
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - start_).count() > seconds_;
  }

 private:
  double seconds_;
  unsigned calls_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace lume::renderer
