// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/agreement.h"

#include "geometry/refine.h"
#include "renderer/bench/deadline.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lume::renderer {
namespace {

using geometry::Accelerator;
using geometry::Hit;
using geometry::Ray;

/// What the reference says, asked once a ray.
class Referee {
 public:
  Referee(const Accelerator& reference, const RaySet& set)
      : reference_(reference), set_(set), answers_(set.rays.size()), asked_(set.rays.size()) {}

  const std::optional<Hit>& closest(std::size_t i) {
    if (!asked_[i]) answers_[i] = reference_.closest_hit(set_.rays[i]);
    asked_[i] = true;
    return answers_[i];
  }

 private:
  const Accelerator& reference_;
  const RaySet& set_;
  std::vector<std::optional<Hit>> answers_;
  std::vector<bool> asked_;
};

/// A step with which 0, step, 2 step ... modulo n visits every number once, and every beginning of
/// which is spread evenly: by the golden ratio.
std::size_t spreading_step(std::size_t n) {
  auto step = static_cast<std::size_t>(0.6180339887 * static_cast<double>(n));
  while (std::gcd(step, n) != 1) ++step;
  return step;
}

}  // namespace

Verdict compare_hits(const geometry::World& world, const geometry::HoleTest* holes, const Ray& ray,
                     const std::optional<Hit>& expected, const std::optional<Hit>& actual) {
  constexpr double k_same_place = 1e-6;
  if (expected == actual) return Verdict::same;
  if (!expected || !actual) return Verdict::mismatch;
  const double a = refine(world, ray, *expected, holes).t;
  const double b = refine(world, ray, *actual, holes).t;
  return std::abs(a - b) <= k_same_place * std::max(std::abs(a), std::abs(b)) ? Verdict::tie
                                                                              : Verdict::mismatch;
}

std::vector<Agreement> compare_structures(const geometry::World& world,
                                          const geometry::HoleTest* holes,
                                          const Accelerator& reference,
                                          std::span<const Accelerator* const> structures,
                                          const RaySet& set, const AgreementSettings& settings) {
  Referee referee(reference, set);
  const std::size_t n = set.rays.size();
  const std::size_t step = n > 0 ? spreading_step(n) : 0;
  std::vector<Agreement> result;
  result.reserve(structures.size());
  for (const Accelerator* structure : structures) {
    Agreement& agreement = result.emplace_back();
    Deadline deadline(settings.budget_seconds);
    const std::size_t most = std::min(n, settings.rays);
    for (std::size_t k = 0; k < most && !deadline.is_over(); ++k) {
      const std::size_t i = k * step % n;
      const Ray& ray = set.rays[i];
      const std::optional<Hit>& expected = referee.closest(i);
      ++agreement.rays;
      if (set.any_hit) {
        if (structure->any_hit(ray) != expected.has_value()) ++agreement.mismatches;
        continue;
      }
      const Verdict verdict =
          compare_hits(world, holes, ray, expected, structure->closest_hit(ray));
      if (verdict == Verdict::tie) ++agreement.ties;
      if (verdict == Verdict::mismatch) ++agreement.mismatches;
    }
  }
  return result;
}

}  // namespace lume::renderer
