// SPDX-License-Identifier: Apache-2.0
// The race counts what it says it counts, and planted mistakes are found.
#include "geometry/parallel.h"
#include "renderer/bench/bench.h"
#include "renderer/bench/closed_mesh.h"
#include "renderer/bench/prove.h"
#include "tests/support/liar.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

namespace lume::renderer {
namespace {

using geometry::Accelerator;
using geometry::Ray;

shading::Scene two_spheres() {
  shading::Scene scene;
  test::make_matte(test::add_surface(scene, test::sphere_mesh(8)), shading::Color(0.5f));
  test::make_matte(
      test::add_surface(scene, test::sphere_mesh(8), test::translation(2.5, 0.3, -1.0)),
      shading::Color(0.2f));
  shading::PunctualLight lamp;
  lamp.position = {0.0f, 5.0f, 5.0f};
  scene.lights.push_back(lamp);
  return scene;
}

Candidate named(const std::string& name) {
  return {name, [name](const geometry::World& world, const geometry::HoleTest* holes) {
            return geometry::make_accelerator(name, world, holes);
          }};
}

Candidate liar(unsigned one_in) {
  return {"liar", [one_in](const geometry::World& world, const geometry::HoleTest* holes) {
            return std::make_unique<test::Liar>(world, holes, test::one_ray_in(one_in));
          }};
}

RaySet random_rays(std::size_t count, bool any_hit, bool coherent) {
  test::Random random(3);
  RaySet set{"random", any_hit, coherent, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 origin = 4.0f * random.direction();
    set.rays.push_back({.origin = origin, .direction = random.cube(0.9f) - origin});
  }
  return set;
}

class BenchMeasure : public testing::Test {
 protected:
  shading::Scene scene_ = two_spheres();
  PreparedScene prepared_{scene_, "brute-force"};
};

TEST_F(BenchMeasure, Shots_HitTheSameHoweverTheyAreShot) {
  for (const bool any_hit : {false, true}) {
    const RaySet set = random_rays(1003, any_hit, true);
    const Accelerator& accelerator = prepared_.accelerator();
    const std::size_t hits = shoot(accelerator, set.rays, any_hit, RayApi::single);
    EXPECT_GT(hits, 500u);
    EXPECT_EQ(shoot(accelerator, set.rays, any_hit, RayApi::batch), hits);
    for (const unsigned threads : {1u, 2u, 3u, 7u}) {
      const Shot shot = shoot_timed(accelerator, set.rays, any_hit, RayApi::batch, threads);
      EXPECT_EQ(shot.hits, hits) << threads;
      EXPECT_GT(shot.seconds, 0.0);
    }
  }
}

TEST_F(BenchMeasure, Race_ReportsEveryoneAndTheBaselineAsOne) {
  const std::array<const Accelerator*, 2> contenders = {&prepared_.accelerator(),
                                                        &prepared_.accelerator()};
  MeasureSettings settings{3, 1, 10.0, 0, {}};
  std::size_t measured = 0;
  settings.on_measured = [&] { ++measured; };
  const RaySet set = random_rays(320, false, true);
  const std::vector<Timing> timings = measure_rays(contenders, set, settings);
  ASSERT_EQ(timings.size(), 4u);
  EXPECT_EQ(measured, measurement_count(2, set, settings));
  for (const Timing& timing : timings) {
    EXPECT_EQ(timing.rays, 320u);
    EXPECT_EQ(timing.hits, timings[0].hits);
    EXPECT_GT(timing.rate.low, 0.0);
    EXPECT_LE(timing.rate.low, timing.rate.median);
    EXPECT_LE(timing.rate.median, timing.rate.high);
  }
  EXPECT_EQ(timings[0].ratio.low, 1.0);
  EXPECT_EQ(timings[0].ratio.high, 1.0);
  EXPECT_EQ(timings[3].structure, 1u);
  EXPECT_EQ(timings[3].api, RayApi::batch);
  EXPECT_TRUE(measure_rays(contenders, {}, settings).empty());
}

TEST_F(BenchMeasure, Budget_TakesFewerRaysOfTheSlow) {
  const std::array<const Accelerator*, 1> contenders = {&prepared_.accelerator()};
  const MeasureSettings settings{1, 1, 1e-6, 0, {}};
  const auto timings = measure_rays(contenders, random_rays(16000, false, false), settings);
  ASSERT_EQ(timings.size(), 1u);
  EXPECT_EQ(timings[0].rays, 16u);
}

TEST_F(BenchMeasure, Agreement_CountsThePlantedMistakes) {
  const test::Liar dishonest(scene_.world, nullptr, test::one_ray_in(10));
  const std::array<const Accelerator*, 2> structures = {&prepared_.accelerator(), &dishonest};
  for (const bool any_hit : {false, true}) {
    const RaySet set = random_rays(2000, any_hit, false);
    std::size_t lies = 0;
    for (const Ray& ray : set.rays) {
      if (prepared_.accelerator().any_hit(ray) && !dishonest.any_hit(ray)) ++lies;
    }
    ASSERT_GT(lies, 50u);
    const auto agreement = compare_structures(scene_.world, nullptr, prepared_.accelerator(),
                                              structures, set, {5000, 100.0});
    EXPECT_EQ(agreement[0].rays, set.rays.size());
    EXPECT_EQ(agreement[0].mismatches, 0u);
    EXPECT_EQ(agreement[1].mismatches, lies);
    EXPECT_EQ(agreement[1].ties, 0u);
  }
}

TEST_F(BenchMeasure, Verdict_TellsTiesFromMistakes) {
  geometry::World world;
  test::add_instance(world, test::square_mesh());
  test::add_instance(world, test::square_mesh());
  test::add_instance(world, test::square_mesh(), test::translation(0.0, 0.0, -1e-3));
  const Ray ray{.origin = {0.1f, 0.2f, 1.0f}};
  const geometry::Hit front{0, 0, 1};
  EXPECT_EQ(compare_hits(world, nullptr, ray, front, front), Verdict::same);
  EXPECT_EQ(compare_hits(world, nullptr, ray, front, geometry::Hit{1, 0, 1}), Verdict::tie);
  EXPECT_EQ(compare_hits(world, nullptr, ray, front, geometry::Hit{2, 0, 1}), Verdict::mismatch);
  EXPECT_EQ(compare_hits(world, nullptr, ray, front, std::nullopt), Verdict::mismatch);
  EXPECT_EQ(compare_hits(world, nullptr, ray, std::nullopt, front), Verdict::mismatch);
  EXPECT_EQ(compare_hits(world, nullptr, ray, std::nullopt, std::nullopt), Verdict::same);
}

TEST_F(BenchMeasure, Cost_OfBruteForceIsEveryPrimitive) {
  if (!prepared_.accelerator().counts_cost()) GTEST_SKIP() << "brute force does not count";
  const auto cost = mean_cost(prepared_.accelerator(), random_rays(160, false, false), 160);
  ASSERT_TRUE(cost);
  EXPECT_EQ(cost->rays, 160u);
  EXPECT_EQ(cost->primitive_tests, static_cast<double>(prepared_.accelerator().stats().primitives));
}

TEST(ClosedMesh, SpheresAreClosed_SquaresAreNot) {
  geometry::Mesh sphere = test::sphere_mesh(6);
  EXPECT_TRUE(examine_closed(sphere).is_closed);
  EXPECT_TRUE(examine_closed(sphere).faces_out);
  for (auto& triangle : sphere.triangles) std::swap(triangle.y, triangle.z);
  EXPECT_TRUE(examine_closed(sphere).is_closed);
  EXPECT_FALSE(examine_closed(sphere).faces_out);
  std::swap(sphere.triangles[7].y, sphere.triangles[7].z);  // one the other way round
  EXPECT_FALSE(examine_closed(sphere).is_closed);
  EXPECT_FALSE(examine_closed(test::square_mesh()).is_closed);
  EXPECT_FALSE(examine_closed({}).is_closed);
}

TEST_F(BenchMeasure, LeakRays_AreInsideAndCountTheLiar) {
  const std::vector<Ray> rays = leak_rays(prepared_, 2000, 0);
  ASSERT_GT(rays.size(), 1900u);
  for (const Ray& ray : rays) {
    const float to_first = length(ray.origin);
    const float to_second = distance(ray.origin, Vec3(2.5f, 0.3f, -1.0f));
    EXPECT_LT(std::min(to_first, to_second), 0.99f);
    // The target is on the wall of one of them.
    const Vec3 target = ray.origin + ray.direction;
    const float off = std::min(std::abs(length(target) - 1.0f),
                               std::abs(distance(target, Vec3(2.5f, 0.3f, -1.0f)) - 1.0f));
    EXPECT_LT(off, 0.08f);
  }
  EXPECT_EQ(count_leaks(prepared_.accelerator(), rays, 100.0).missed_closest, 0u);
  const test::Liar dishonest(scene_.world, nullptr, test::one_ray_in(20));
  const Leaks leaks = count_leaks(dishonest, rays, 100.0);
  EXPECT_EQ(leaks.rays, rays.size());
  EXPECT_GT(leaks.missed_closest, 20u);
  EXPECT_EQ(leaks.missed_closest, leaks.missed_any);
}

TEST_F(BenchMeasure, WholeBench_HasARowForEverything) {
  const std::vector<Candidate> candidates = {named("embree"), named("brute-force"), liar(10)};
  const std::vector<RaySet> sets = {random_rays(160, false, true), random_rays(160, true, false)};
  BenchSettings settings;
  settings.measure.rounds = 1;
  settings.measure.budget_seconds = 0.01;
  settings.leak_rays = 100;
  double last = 0.0;
  settings.on_progress = [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  const BenchReport report = run_bench(prepared_, candidates, sets, settings);
  EXPECT_NEAR(last, 1.0, 1e-9);
  ASSERT_EQ(report.structures.size(), 3u);
  ASSERT_EQ(report.sets.size(), 2u);
  EXPECT_EQ(report.sets[0].timings.size(), 6u);
  EXPECT_EQ(report.sets[1].timings.size(), 3u);
  EXPECT_EQ(report.sets[0].agreement[1].mismatches, 0u);
  EXPECT_GT(report.sets[0].agreement[2].mismatches, 0u);
  EXPECT_GT(report.structures[2].leaks.missed_any, 0u);
}

class Proof : public testing::Test {
 protected:
  [[nodiscard]] std::vector<ProofOfOne> run(const std::vector<Candidate>& candidates) const {
    ProofSettings settings;
    settings.render.width = 32;
    settings.render.height = 24;
    settings.render.spp = 2;
    return prove(scene_, geometry::look_at({0.5f, 0.5f, 6.0f}, Vec3(0.0f), 0.9f), candidates,
                 settings);
  }
  shading::Scene scene_ = two_spheres();
};

TEST_F(Proof, HonestStructures_Agree) {
  for (const ProofOfOne& proof : run({named("embree"), named("brute-force")})) {
    EXPECT_FALSE(proof.mismatch) << proof.name;
  }
}

TEST_F(Proof, Liar_IsCaughtByTheFirstRay) {
  const auto proofs = run({named("brute-force"), liar(50)});
  ASSERT_TRUE(proofs[1].mismatch);
  const Mismatch& mismatch = *proofs[1].mismatch;
  EXPECT_GT(mismatch.pixels, 0u);
  // The first pixel that differs, by a search of our own.
  std::size_t first = 0;
  while (proofs[0].film.pixels[first] == proofs[1].film.pixels[first]) ++first;
  EXPECT_EQ(mismatch.x, static_cast<int>(first % 32));
  EXPECT_EQ(mismatch.y, static_cast<int>(first / 32));
  ASSERT_TRUE(mismatch.ray);
  const test::Liar dishonest(scene_.world, nullptr, test::one_ray_in(50));
  const auto honest = geometry::make_accelerator("brute-force", scene_.world, nullptr);
  EXPECT_TRUE(test::one_ray_in(50)(mismatch.ray->ray));
  EXPECT_EQ(mismatch.ray->hits[0], honest->closest_hit(mismatch.ray->ray));
  EXPECT_TRUE(mismatch.ray->hits[0].has_value());
  EXPECT_EQ(mismatch.ray->hits[1], std::nullopt);
  EXPECT_TRUE(mismatch.ray->occluded[0]);
  EXPECT_FALSE(mismatch.ray->occluded[1]);
}

TEST_F(Proof, CostAovs_AreWhatTheStructureCounts) {
  const geometry::Camera camera = geometry::look_at({0.5f, 0.5f, 6.0f}, Vec3(0.0f), 0.9f);
  const PreparedScene prepared(scene_, "brute-force");
  if (!prepared.accelerator().counts_cost()) GTEST_SKIP() << "brute force does not count";
  const std::array aovs = {Aov::primitive_tests, Aov::nodes};
  const Ray ray = camera.generate_ray({0.5f, 0.5f}, 1.0f);
  std::array<float, 2> values{};
  evaluate_aovs(aovs, prepared, camera, ray, values);
  geometry::TraversalCost cost;
  (void)prepared.accelerator().closest_hit_counted(ray, cost);
  EXPECT_EQ(values[0], static_cast<float>(cost.primitive_tests));
  EXPECT_EQ(values[1], static_cast<float>(cost.nodes));
  EXPECT_GT(values[0], 0.0f);
}

}  // namespace
}  // namespace lume::renderer
