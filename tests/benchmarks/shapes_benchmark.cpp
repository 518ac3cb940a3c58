// SPDX-License-Identifier: Apache-2.0
// Nanoseconds for a ray against each shape, at hit rates of 0, 33, 66 and 100%. The sphere, the
// plane and the quadric also race the same formula written out in the loop, in turns within one
// run: `inline_ns` is its time and `ratio` what Lume's costs for each of its nanoseconds.
#include "geometry/shapes/shape.h"
#include "tests/support/random.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace lume::geometry {
namespace {

constexpr std::size_t k_rays = 4096;

/// Rays from around the shape, of which `percent` meet it.
std::vector<ObjectRay> make_rays(const Shape& shape, std::int64_t percent) {
  test::Random random(1);
  std::vector<ObjectRay> rays;
  rays.reserve(k_rays);
  while (rays.size() < k_rays) {
    ObjectRay ray{4.0 * DVec3(random.direction()), {}};
    ray.direction = normalize(DVec3(random.cube(1.2f)) - ray.origin);
    const bool wanted = static_cast<std::int64_t>(rays.size() % 100) < percent;
    if (meets(shape, ray) == wanted) rays.push_back(ray);
  }
  std::shuffle(rays.begin(), rays.end(), std::mt19937(2));
  return rays;
}

DMat4 saddle() {
  DMat4 q(0.0);
  q[0][0] = 1.0;
  q[2][2] = -1.0;
  q[1][3] = q[3][1] = -0.5;
  return q;
}

std::vector<BezierPatch> dome() {
  BezierPatch patch;
  for (std::size_t i = 0; i < 16; ++i) {
    const double x = static_cast<double>(i % 4) / 1.5 - 1.0;
    const std::size_t row = i / 4;
    const double z = static_cast<double>(row) / 1.5 - 1.0;
    patch[i] = {x, 1.0 - x * x - z * z, z};
  }
  return {patch};
}

const std::map<std::string, Shape>& shapes() {
  const DVec3 one(1.0);
  static const std::map<std::string, Shape> k_shapes = {
      {"plane", Plane{2.0, 2.0}},
      {"disk", Disk{1.0, 0.2}},
      {"box", Box{DVec3(0.7)}},
      {"sphere", Sphere{1.0}},
      {"cylinder", Cylinder{1.5, 0.8, 0.4}},
      {"capsule", Capsule(1.0, 0.5, 0.3)},
      {"quadric", Quadric(saddle(), -one, one, false)},
      {"quadric_capped", Quadric(saddle(), -one, one, true)},
      {"polygon", Polygon({{{-1, 0, -1}, {-1, 0, 1}, {0, 0, 0.2}, {1, 0, 1}, {1, 0, -1}}})},
      {"torus", Torus{0.7, 0.3}},
      {"implicit_sphere", ImplicitSurface(Expression("x^2 + y^2 + z^2 - 1"), -one, one)},
      {"bezier_surface", BezierSurface(dome())}};
  return k_shapes;
}

/// One pass over all rays: the first crossing of each.
double pass(const Shape& shape, const std::vector<ObjectRay>& rays) {
  return std::visit(
      [&](const auto& s) {
        double sum = 0.0;
        for (const ObjectRay& ray : rays) {
          if (const auto crossing = s.intersect(ray)) sum += crossing->t;
        }
        return sum;
      },
      shape);
}

void measure_shape(benchmark::State& state, const std::string& name) {
  const Shape& shape = shapes().at(name);
  const std::vector<ObjectRay> rays = make_rays(shape, state.range(0));
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(pass(shape, rays));
  state.counters["per_ray"] =
      benchmark::Counter(static_cast<double>(state.iterations() * k_rays),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// The formulas as a textbook's reader would write them.

double plane_formula(const ObjectRay& ray, const Plane& plane) {
  const double t = -ray.origin.y / ray.direction.y;
  if (!(t >= ray.t_min && t <= ray.t_max)) return 0.0;
  const DVec3 p = ray.origin + t * ray.direction;
  return std::abs(p.x) <= 0.5 * plane.size_x && std::abs(p.z) <= 0.5 * plane.size_z ? t : 0.0;
}

double sphere_formula(const ObjectRay& ray, const Sphere& sphere) {
  const double a = dot(ray.direction, ray.direction);
  const double b = dot(ray.origin, ray.direction);
  const double c = dot(ray.origin, ray.origin) - sphere.radius * sphere.radius;
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0) return 0.0;
  const double root = std::sqrt(discriminant);
  const double first = (-b - root) / a;
  if (first >= ray.t_min && first <= ray.t_max) return first;
  const double second = (-b + root) / a;
  return second >= ray.t_min && second <= ray.t_max ? second : 0.0;
}

double quadric_formula(const ObjectRay& ray, const DMat4& q) {
  const glm::dvec4 o(ray.origin, 1.0);
  const glm::dvec4 d(ray.direction, 0.0);
  const glm::dvec4 qo = q * o;
  const glm::dvec4 qd = q * d;
  const double a = glm::dot(d, qd);
  const double b = glm::dot(o, qd);
  const double c = glm::dot(o, qo);
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0) return 0.0;
  const double root = std::sqrt(discriminant);
  const auto counts = [&](double t) {
    const DVec3 p = ray.origin + t * ray.direction;
    return t >= ray.t_min && t <= ray.t_max &&
           glm::all(glm::lessThanEqual(glm::abs(p), DVec3(1.0)));
  };
  const double first = (-b - root) / a;
  const double second = (-b + root) / a;
  if (counts(std::min(first, second))) return std::min(first, second);
  return counts(std::max(first, second)) ? std::max(first, second) : 0.0;
}

/// Lume's test and the written-out formula in turns, pass by pass, so that both see the same
/// machine.
template <class Formula>
void race(benchmark::State& state, const std::string& name, const Formula& formula) {
  using Clock = std::chrono::steady_clock;
  const Shape& shape = shapes().at(name);
  const std::vector<ObjectRay> rays = make_rays(shape, state.range(0));
  double ours = 0.0;
  double theirs = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    const auto start = Clock::now();
    benchmark::DoNotOptimize(pass(shape, rays));
    const auto middle = Clock::now();
    double sum = 0.0;
    for (const ObjectRay& ray : rays) sum += formula(ray);
    benchmark::DoNotOptimize(sum);
    const auto end = Clock::now();
    ours += std::chrono::duration<double>(middle - start).count();
    theirs += std::chrono::duration<double>(end - middle).count();
    state.SetIterationTime(std::chrono::duration<double>(middle - start).count());
  }
  const double passes = static_cast<double>(state.iterations() * k_rays) * 1e-9;
  state.counters["lume_ns"] = ours / passes;
  state.counters["inline_ns"] = theirs / passes;
  state.counters["ratio"] = ours / theirs;
}

void at_all_hit_rates(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("hits%")->Arg(0)->Arg(33)->Arg(66)->Arg(100);
}

[[maybe_unused]] const bool k_registered = [] {
  for (const auto& [name, shape] : shapes()) {
    at_all_hit_rates(benchmark::RegisterBenchmark(
        name.c_str(), [name = name](benchmark::State& state) { measure_shape(state, name); }));
  }
  const auto add_race = [](const std::string& name, const auto& formula) {
    auto* benchmark =
        benchmark::RegisterBenchmark((name + "_against_inline").c_str(),
                                     [=](benchmark::State& state) { race(state, name, formula); });
    at_all_hit_rates(benchmark->UseManualTime());
  };
  add_race("plane", [](const ObjectRay& ray) { return plane_formula(ray, {2.0, 2.0}); });
  add_race("sphere", [](const ObjectRay& ray) { return sphere_formula(ray, {1.0}); });
  add_race("quadric", [q = saddle()](const ObjectRay& ray) { return quadric_formula(ray, q); });
  return true;
}();

}  // namespace
}  // namespace lume::geometry
