// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/render_stats.h"

#include "io/error.h"
#include "lume_version.h"
#include "renderer/cli/version.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <system_error>
#include <utility>

namespace lume::cli {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw io::Error(io::ErrorKind::input_output, path.string(), "", reason);
}

}  // namespace

double Stopwatch::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

double Stopwatch::lap() {
  const double seconds = elapsed();
  start_ = std::chrono::steady_clock::now();
  return seconds;
}

double RenderStats::rays_per_second() const {
  return render_seconds > 0.0 ? static_cast<double>(rays.total()) / render_seconds : 0.0;
}

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

std::string stats_to_json(const RenderStats& stats, const RenderOptions& options) {
  const nlohmann::ordered_json json = {
      {"version", k_version},
      {"scene", options.scene_file},
      {"integrator", options.integrator},
      {"accelerator", options.accelerator},
      {"seed", options.seed},
      {"width", stats.width},
      {"height", stats.height},
      {"spp", options.spp},
      {"threads", stats.threads},
      {"instruction_set", instruction_set()},
      {"interrupted", stats.interrupted},
      {"non_finite_samples", stats.non_finite_samples},
      {"load_seconds", stats.load_seconds},
      {"build_seconds", stats.build_seconds},
      {"render_seconds", stats.render_seconds},
      {"write_seconds", stats.write_seconds},
      {"rays",
       {{"camera", stats.rays.camera},
        {"shadow", stats.rays.shadow},
        {"reflection", stats.rays.reflection},
        {"refraction", stats.rays.refraction}}},
      {"rays_per_second", stats.rays_per_second()},
      {"peak_memory_bytes", peak_memory_bytes()},
  };
  // A file's name need not be UTF-8, JSON must be.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void check_text_writable(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (std::filesystem::is_directory(path, ignored) || !path.has_filename()) {
    fail(path, "is a folder, expected the name of a file");
  }
  if (!std::filesystem::is_directory(folder, ignored)) fail(path, "its folder does not exist");
  if (access(folder.c_str(), W_OK | X_OK) != 0) fail(path, "its folder cannot be written to");
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  const std::filesystem::path beside = path.string() + fmt::format(".{}.part", getpid());
  std::ofstream file(beside, std::ios::binary);
  file << text;
  file.close();
  std::error_code error;
  if (file) {
    std::filesystem::rename(beside, path, error);
    if (!error) return;
  }
  std::error_code ignored;
  std::filesystem::remove(beside, ignored);
  fail(path, error ? "cannot be written: " + error.message() : "cannot be written");
}

}  // namespace lume::cli
