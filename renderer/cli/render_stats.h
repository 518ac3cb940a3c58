// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderer/cli/render_options.h"
#include "renderer/integrator.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

namespace lume::cli {

/// Seconds between one call and the next.
class Stopwatch {
 public:
  /// Since the last lap, or since the start.
  double lap();
  /// Since the last lap, which goes on.
  [[nodiscard]] double elapsed() const;

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// What a render cost.
struct RenderStats {
  double load_seconds = 0.0;   ///< scene and environment, decoded
  double build_seconds = 0.0;  ///< accelerator and light tables
  double render_seconds = 0.0;
  double write_seconds = 0.0;
  renderer::RayCounts rays;
  std::uint64_t non_finite_samples = 0;
  unsigned threads = 0;
  int width = 0;  ///< of the whole picture
  int height = 0;
  bool interrupted = false;

  /// 0 for a render that took no time.
  [[nodiscard]] double rays_per_second() const;
};

/// The most memory this process has held so far.
[[nodiscard]] std::uint64_t peak_memory_bytes();

[[nodiscard]] std::string stats_to_json(const RenderStats& stats, const RenderOptions& options);

/// Throws io::Error(input_output) now if write_text would later fail for want of a folder or of the
/// right to write there.
void check_text_writable(const std::filesystem::path& path);
/// The file appears whole or not at all. Throws io::Error(input_output).
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace lume::cli
