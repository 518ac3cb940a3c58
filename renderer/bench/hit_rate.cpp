// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/hit_rate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lume::renderer {
namespace {

/// Whether number i of n is one of the k that are kept, as evenly as can be.
bool is_kept(std::size_t i, std::size_t n, std::size_t k) { return (i + 1) * k / n > i * k / n; }

}  // namespace

std::optional<HitCounts> counts_for_hit_rate(const HitCounts& recorded, double share) {
  const auto most = [](std::size_t available, double part) {
    return part > 0.0 ? static_cast<double>(available) / part : INFINITY;
  };
  const double total =
      std::floor(std::min(most(recorded.hits, share), most(recorded.misses, 1.0 - share)));
  if (!(total >= 1.0)) return std::nullopt;
  const auto count = static_cast<std::size_t>(total);
  const auto wanted = static_cast<std::size_t>(std::llround(total * share));
  const HitCounts kept{std::min(wanted, recorded.hits), std::min(count - wanted, recorded.misses)};
  return kept;
}

HitCounts keep_hit_rate(RaySet& set, const geometry::Accelerator& accelerator, double share) {
  std::vector<std::uint8_t> hits;
  hits.reserve(set.rays.size());
  HitCounts recorded;
  for (const geometry::Ray& ray : set.rays) {
    hits.push_back(accelerator.any_hit(ray) ? 1 : 0);
    ++(hits.back() != 0 ? recorded.hits : recorded.misses);
  }
  const HitCounts wanted = counts_for_hit_rate(recorded, share).value_or(HitCounts{});
  HitCounts seen;
  std::vector<geometry::Ray> kept;
  kept.reserve(wanted.total());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const bool keep = hits[i] != 0 ? is_kept(seen.hits++, recorded.hits, wanted.hits)
                                   : is_kept(seen.misses++, recorded.misses, wanted.misses);
    if (keep) kept.push_back(set.rays[i]);
  }
  set.rays = std::move(kept);
  return recorded;
}

}  // namespace lume::renderer
