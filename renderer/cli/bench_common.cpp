// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/bench_modes.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace lume::cli {
namespace {

std::string describe_vector(const geometry::Vec3& v) {
  return fmt::format("{:a} {:a} {:a}  ({:.9g}, {:.9g}, {:.9g})", v.x, v.y, v.z, v.x, v.y, v.z);
}

}  // namespace

std::vector<renderer::Candidate> name_candidates(const std::vector<std::string>& names,
                                                 const Viewpoint& view,
                                                 const geometry::AcceleratorOptions& rules) {
  std::vector<renderer::Candidate> candidates;
  candidates.reserve(names.size());
  for (const std::string& name : names) {
    candidates.push_back(
        {name, [=](const geometry::World& world, const geometry::HoleTest* holes) {
           auto accelerator = geometry::make_accelerator(name, world, holes, rules);
           accelerator->prepare_view(view.camera.camera, view.size.width, view.size.height);
           return accelerator;
         }});
  }
  return candidates;
}

BenchOptions options_for(const BenchOptions& options, const std::string& scene_file, int width) {
  BenchOptions result = options;
  result.scene_file = scene_file;
  if (!result.width && !result.height) result.width = width;
  return result;
}

Progress::Style bench_progress_style(const BenchOptions& options) {
  const bool shown = options.verbosity != Verbosity::quiet && isatty(fileno(stderr)) == 1;
  return shown ? Progress::Style::bar : Progress::Style::none;
}

std::string describe_ray(const geometry::Ray& ray) {
  return fmt::format("  origin     {}\n  direction  {}\n  t_min {:a}  t_max {:a}\n",
                     describe_vector(ray.origin), describe_vector(ray.direction), ray.t_min,
                     ray.t_max);
}

std::string describe_hit(const std::optional<geometry::Hit>& hit, const geometry::Ray& ray,
                         const renderer::PreparedScene& prepared) {
  if (!hit) return "nothing";
  const double t = prepared.crossing_at(ray, *hit).t;
  return fmt::format("instance {}, geometry {}, primitive {}, t = {:a} ({:.17g})", hit->instance,
                     hit->geometry, hit->primitive, t, t);
}

std::string describe_disagreement(const renderer::Disagreement& found, const std::string& first,
                                  const std::string& second,
                                  const renderer::PreparedScene& prepared) {
  const std::string* const names[2] = {&first, &second};
  std::string text = describe_ray(found.ray);
  const std::size_t width = std::max(first.size(), second.size());
  for (int i = 0; i < 2; ++i) {
    text += fmt::format("  {:<{}}  closest hit: {}; any hit: {}\n", *names[i], width,
                        describe_hit(found.hits[i], found.ray, prepared),
                        found.occluded[i] ? "yes" : "no");
  }
  return text;
}

}  // namespace lume::cli
