// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/measure.h"

#include <algorithm>
#include <random>
#include <utility>

namespace lume::renderer {
namespace {

using geometry::Accelerator;
using geometry::Ray;

/// A contender in the race over one ray set.
struct Lane {
  Timing timing;
  std::vector<Ray> part;      ///< of the rays; empty: all of them
  std::vector<double> rates;  ///< of each round
};

std::size_t apis_of(const RaySet& set) { return set.coherent ? 2 : 1; }

class Race {
 public:
  Race(std::span<const Accelerator* const> contenders, const RaySet& set,
       const MeasureSettings& settings);

  /// Everyone once, in an order that the round's number gives.
  void run(std::size_t round);
  [[nodiscard]] std::vector<Timing> results() const;

 private:
  [[nodiscard]] Shot shoot_lane(const Lane& lane, std::span<const Ray> rays) const {
    return shoot_timed(*contenders_[lane.timing.structure], rays, set_.any_hit, lane.timing.api,
                       settings_.threads);
  }
  [[nodiscard]] std::size_t affordable_rays(const Lane& lane) const;

  std::span<const Accelerator* const> contenders_;
  const RaySet& set_;
  const MeasureSettings& settings_;
  std::vector<Lane> lanes_;
};

Race::Race(std::span<const Accelerator* const> contenders, const RaySet& set,
           const MeasureSettings& settings)
    : contenders_(contenders), set_(set), settings_(settings) {
  lanes_.resize(contenders.size() * apis_of(set));
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    Lane& lane = lanes_[i];
    lane.timing.structure = i % contenders.size();
    lane.timing.api = i < contenders.size() ? RayApi::single : RayApi::batch;
    lane.timing.rays = affordable_rays(lane);
    if (lane.timing.rays < set.rays.size()) lane.part = spread_rays(set.rays, lane.timing.rays);
    lane.rates.reserve(settings.rounds);
  }
}

/// Tries four times as many rays again and again, up to a quarter of the budget.
std::size_t Race::affordable_rays(const Lane& lane) const {
  const std::size_t all = set_.rays.size();
  for (std::size_t count = k_batch_size; count < all; count *= 4) {
    const double seconds = shoot_lane(lane, spread_rays(set_.rays, count)).seconds;
    if (4.0 * seconds < settings_.budget_seconds) continue;
    const double affordable = settings_.budget_seconds / seconds * static_cast<double>(count);
    const auto batches = static_cast<std::size_t>(affordable / static_cast<double>(k_batch_size));
    return std::min(all, std::max<std::size_t>(batches, 1) * k_batch_size);
  }
  return all;
}

void Race::run(std::size_t round) {
  constexpr std::size_t k_warm_up = 0;
  std::vector<std::size_t> order(lanes_.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::mt19937_64 random(settings_.seed + round);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  for (const std::size_t i : order) {
    Lane& lane = lanes_[i];
    const std::span<const Ray> rays(lane.part.empty() ? set_.rays : lane.part);
    const Shot shot = shoot_lane(lane, rays);
    lane.timing.hits = shot.hits;
    if (round != k_warm_up) {
      lane.rates.push_back(static_cast<double>(rays.size()) / std::max(shot.seconds, 1e-9));
    }
    if (settings_.on_measured) settings_.on_measured();
  }
}

std::vector<Timing> Race::results() const {
  std::vector<Timing> timings;
  timings.reserve(lanes_.size());
  for (const Lane& lane : lanes_) {
    std::vector<double> ratios(lane.rates.size());
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      ratios[i] = lane.rates[i] / lanes_.front().rates[i];
    }
    Timing& timing = timings.emplace_back(lane.timing);
    timing.rate = estimate_median(lane.rates);
    timing.ratio = estimate_median(std::move(ratios));
  }
  return timings;
}

}  // namespace

std::size_t measurement_count(std::size_t structures, const RaySet& set,
                              const MeasureSettings& settings) {
  return set.rays.empty() ? 0 : structures * apis_of(set) * (settings.rounds + 1);
}

std::vector<Timing> measure_rays(std::span<const Accelerator* const> contenders, const RaySet& set,
                                 const MeasureSettings& settings) {
  if (set.rays.empty() || contenders.empty()) return {};
  Race race(contenders, set, settings);
  for (std::size_t round = 0; round <= settings.rounds; ++round) race.run(round);
  return race.results();
}

std::vector<Ray> spread_rays(std::span<const Ray> rays, std::size_t count) {
  if (count >= rays.size()) return {rays.begin(), rays.end()};
  const std::size_t batches = rays.size() / k_batch_size;
  const std::size_t wanted = (count + k_batch_size - 1) / k_batch_size;
  std::vector<Ray> part;
  part.reserve(wanted * k_batch_size);
  for (std::size_t i = 0; i < wanted && batches > 0; ++i) {
    const auto batch = rays.subspan(i * batches / wanted * k_batch_size, k_batch_size);
    part.insert(part.end(), batch.begin(), batch.end());
  }
  // A set too short for whole runs is taken from its beginning.
  if (part.size() < count)
    part.assign(rays.begin(), rays.begin() + static_cast<std::ptrdiff_t>(count));
  part.resize(count);
  return part;
}

}  // namespace lume::renderer
