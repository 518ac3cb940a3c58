// SPDX-License-Identifier: Apache-2.0
// Haines' sphereflake of 7,381, 66,430 and 597,871 spheres: the time to build a hierarchy over it,
// and to trace a picture's 1024x1024 primary rays on one thread. Nine times the spheres must cost
// far less than nine times the rays' time (Haines 1987, "A Proposal for Standard Graphics
// Environments").
#include "geometry/accelerators/accelerator.h"
#include "geometry/camera.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <map>
#include <memory>

namespace lume::geometry {
namespace {

constexpr int k_size = 1024;

/// A sphere and, `level` deep, nine children of a third of its radius around it: six around its
/// equator, three on top, where the top is away from the parent.
void add_sphere(World& world, const DVec3& center, const DVec3& top, double radius, int level) {
  DMat4 matrix(radius);
  matrix[3] = glm::dvec4(center, 1.0);
  world.instances.push_back({"", 0, Transform(matrix)});
  if (level == 0) return;
  const Frame frame = make_frame(Vec3(top));
  for (int child = 0; child < 9; ++child) {
    const bool is_on_equator = child < 6;
    const double around = k_turn / 6.0 * (is_on_equator ? child : 2.0 * child + 0.5);
    const double up = is_on_equator ? 0.0 : std::sqrt(2.0 / 3.0);
    const double out = std::sqrt(1.0 - up * up);
    const DVec3 axis = normalize(out * std::cos(around) * DVec3(frame.tangent) +
                                 out * std::sin(around) * DVec3(frame.bitangent) + up * top);
    add_sphere(world, center + 4.0 / 3.0 * radius * axis, axis, radius / 3.0, level - 1);
  }
}

const World& sphereflake(int level) {
  static std::map<int, World> worlds;
  World& world = worlds[level];
  if (world.objects.empty()) {
    world.objects.emplace_back().geometries.push_back({Shape(Sphere{1.0})});
    add_sphere(world, DVec3(0.0), DVec3(0.0, 1.0, 0.0), 0.5, level);
  }
  return world;
}

void build(benchmark::State& state) {
  const World& world = sphereflake(static_cast<int>(state.range(0)));
  std::unique_ptr<Accelerator> accelerator;
  for ([[maybe_unused]] auto _ : state) accelerator = make_accelerator("embree", world, nullptr);
  state.counters["spheres"] = static_cast<double>(world.instances.size());
  state.counters["bytes_per_sphere"] = static_cast<double>(accelerator->stats().memory_bytes) /
                                       static_cast<double>(world.instances.size());
}

void trace_primary_rays(benchmark::State& state) {
  const World& world = sphereflake(static_cast<int>(state.range(0)));
  const auto accelerator = make_accelerator("embree", world, nullptr);
  const Camera camera = look_at({2.1f, 1.7f, 1.3f}, Vec3(0.0f), k_pi / 4.0f);
  std::size_t hits = 0;
  for ([[maybe_unused]] auto _ : state) {
    hits = 0;
    for (int y = 0; y < k_size; ++y) {
      for (int x = 0; x < k_size; ++x) {
        const Vec2 at = (Vec2(x, y) + 0.5f) / static_cast<float>(k_size);
        hits += accelerator->closest_hit(camera.generate_ray(at, 1.0f)) ? 1u : 0u;
      }
    }
    benchmark::DoNotOptimize(hits);
  }
  state.counters["hits%"] = 100.0 * static_cast<double>(hits) / (k_size * k_size);
  state.counters["M_rays/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * k_size * k_size * 1e-6,
                         benchmark::Counter::kIsRate);
}

BENCHMARK(build)
    ->Name("sphereflake_build")
    ->ArgName("level")
    ->DenseRange(4, 6)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(trace_primary_rays)
    ->Name("sphereflake_primary")
    ->ArgName("level")
    ->DenseRange(4, 6)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lume::geometry
