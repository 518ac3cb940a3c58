// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/shoot.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <optional>
#include <thread>
#include <vector>

namespace lume::renderer {
namespace {

using Clock = std::chrono::steady_clock;
using geometry::Accelerator;
using geometry::Ray;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Of the processor, all threads together: what a structure does on threads of its own counts too,
/// what other programs do meanwhile does not.
double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Calls shoot_batch(rays) for each run of k_batch_size rays and adds up what it returns.
template <class ShootBatch>
std::size_t in_batches(std::span<const Ray> rays, const ShootBatch& shoot_batch) {
  std::size_t hits = 0;
  for (std::size_t i = 0; i < rays.size(); i += k_batch_size) {
    hits += shoot_batch(rays.subspan(i, std::min(k_batch_size, rays.size() - i)));
  }
  return hits;
}

std::size_t closest_in_batches(const Accelerator& accelerator, std::span<const Ray> rays) {
  return in_batches(rays, [&](std::span<const Ray> batch) {
    std::array<std::optional<geometry::Hit>, k_batch_size> hits;
    const auto end = hits.begin() + static_cast<std::ptrdiff_t>(batch.size());
    accelerator.closest_hits(batch, std::span(hits).first(batch.size()));
    return static_cast<std::size_t>(
        std::count_if(hits.begin(), end, [](const auto& hit) { return hit.has_value(); }));
  });
}

std::size_t any_in_batches(const Accelerator& accelerator, std::span<const Ray> rays) {
  return in_batches(rays, [&](std::span<const Ray> batch) {
    std::array<std::uint8_t, k_batch_size> hits{};
    accelerator.any_hits(batch, std::span(hits).first(batch.size()));
    return static_cast<std::size_t>(
        std::count_if(hits.begin(), hits.end(), [](std::uint8_t hit) { return hit != 0; }));
  });
}

/// Stretch number i of n, of whole batches.
std::span<const Ray> stretch(std::span<const Ray> rays, std::size_t i, std::size_t n) {
  const std::size_t batches = (rays.size() + k_batch_size - 1) / k_batch_size;
  const std::size_t begin = std::min(rays.size(), i * batches / n * k_batch_size);
  const std::size_t end = std::min(rays.size(), (i + 1) * batches / n * k_batch_size);
  return rays.subspan(begin, end - begin);
}

}  // namespace

std::size_t shoot(const Accelerator& accelerator, std::span<const Ray> rays, bool any_hit,
                  RayApi api) {
  if (api == RayApi::batch) {
    return any_hit ? any_in_batches(accelerator, rays) : closest_in_batches(accelerator, rays);
  }
  std::size_t hits = 0;
  if (any_hit) {
    for (const Ray& ray : rays) hits += accelerator.any_hit(ray) ? 1 : 0;
  } else {
    for (const Ray& ray : rays) hits += accelerator.closest_hit(ray).has_value() ? 1 : 0;
  }
  return hits;
}

Shot shoot_timed(const Accelerator& accelerator, std::span<const Ray> rays, bool any_hit,
                 RayApi api, unsigned threads) {
  if (threads <= 1) {
    const double start = processor_seconds();
    const std::size_t hits = shoot(accelerator, rays, any_hit, api);
    return {processor_seconds() - start, hits};
  }
  // Threads of their own, and not those of parallel_for: there one that wakes late would leave its
  // stretch to another. All wait for the start, so that waking up does not count.
  std::atomic<unsigned> waiting{0};
  std::atomic<bool> started{false};
  std::atomic<std::size_t> hits{0};
  std::vector<std::thread> workers;
  workers.reserve(threads);
  for (unsigned i = 0; i < threads; ++i) {
    workers.emplace_back([&, i] {
      ++waiting;
      while (!started) std::this_thread::yield();
      hits += shoot(accelerator, stretch(rays, i, threads), any_hit, api);
    });
  }
  while (waiting < threads) std::this_thread::yield();
  const auto start = Clock::now();
  started = true;
  for (std::thread& worker : workers) worker.join();
  return {seconds_since(start), hits};
}

}  // namespace lume::renderer
