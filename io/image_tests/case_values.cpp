// SPDX-License-Identifier: Apache-2.0
#include "io/image_tests/case_values.h"

#include "io/compare/flip.h"
#include "io/image_tests/placeholders.h"
#include "io/nearest_name.h"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>
#include <utility>

namespace lume::io {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();
constexpr int k_most_seeds = 1024;
constexpr double k_longest_timeout = 86400.0;

struct LimitKey {
  const char* name;
  std::optional<double> CompareLimits::*limit;
};

constexpr LimitKey k_limits[] = {
    {"max", &CompareLimits::max},           {"mae", &CompareLimits::mae},
    {"rmse", &CompareLimits::rmse},         {"relmse", &CompareLimits::relmse},
    {"outliers", &CompareLimits::outliers}, {"psnr", &CompareLimits::psnr},
    {"ssim", &CompareLimits::ssim},         {"flip", &CompareLimits::flip},
    {"flip_max", &CompareLimits::flip_max},
};

CompareLimits read_limits(const std::filesystem::path& file, const ManifestTable& table) {
  CompareLimits limits;
  const toml::table* values = table.table("limits");
  if (values == nullptr) return limits;
  std::vector<std::string> names;
  for (const LimitKey& key : k_limits) names.emplace_back(key.name);
  const ManifestTable given(file, *values, "limits", names);
  for (const LimitKey& key : k_limits) limits.*key.limit = given.number(key.name, 0.0, k_infinity);
  return limits;
}

std::optional<Tier> read_tier(const ManifestTable& table) {
  const std::optional<std::string> name = table.text("tier");
  if (!name) return std::nullopt;
  std::vector<std::string> names;
  for (const Tier tier : {Tier::exact, Tier::statistical, Tier::perceptual}) {
    if (*name == tier_name(tier)) return tier;
    names.emplace_back(tier_name(tier));
  }
  table.fail(table.line("tier"),
             fmt::format("tier: unknown tier '{}'{}", *name, list_names(*name, names)));
}

std::vector<std::string> read_render(const ManifestTable& table) {
  std::vector<std::string> words = table.text_or_texts("render");
  if (words.size() != 1) return words;
  try {
    return split_words(words.front());
  } catch (const std::invalid_argument& error) {
    table.fail(table.line("render"), fmt::format("render: {}", error.what()));
  }
}

template <class T>
void take(std::optional<T>& value, const std::optional<T>& other) {
  if (other) value = other;
}

void append(std::vector<std::string>& values, const std::vector<std::string>& others) {
  values.insert(values.end(), others.begin(), others.end());
}

}  // namespace

const char* tier_name(Tier tier) {
  switch (tier) {
    case Tier::exact:
      return "exact";
    case Tier::statistical:
      return "statistical";
    case Tier::perceptual:
      break;
  }
  return "perceptual";
}

void CaseValues::refine(const CaseValues& other) {
  take(tier, other.tier);
  take(reference, other.reference);
  append(render, other.render);
  for (const LimitKey& key : k_limits) take(limits.*key.limit, other.limits.*key.limit);
  take(pixels_per_degree, other.pixels_per_degree);
  take(seeds, other.seeds);
  take(significance, other.significance);
  take(timeout, other.timeout);
  append(requires_environment, other.requires_environment);
  take(skip, other.skip);
}

std::vector<std::string> case_value_keys(bool with_skip) {
  std::vector<std::string> keys = {"tier",
                                   "reference",
                                   "render",
                                   "limits",
                                   "seeds",
                                   "significance",
                                   "timeout",
                                   "pixels_per_degree",
                                   "requires_environment"};
  if (with_skip) keys.emplace_back("skip");
  return keys;
}

CaseValues read_case_values(const std::filesystem::path& file, const ManifestTable& table) {
  CaseValues values;
  values.tier = read_tier(table);
  values.reference = table.text("reference");
  values.render = read_render(table);
  values.limits = read_limits(file, table);
  values.pixels_per_degree = table.number("pixels_per_degree", k_flip_least_pixels_per_degree,
                                          k_flip_most_pixels_per_degree);
  values.seeds = table.whole("seeds", 2, k_most_seeds);
  values.significance = table.number("significance", 1e-12, 0.5);
  values.timeout = table.number("timeout", 0.001, k_longest_timeout);
  values.requires_environment = table.text_or_texts("requires_environment");
  values.skip = table.text("skip");
  return values;
}

}  // namespace lume::io
