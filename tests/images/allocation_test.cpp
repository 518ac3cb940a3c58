// SPDX-License-Identifier: Apache-2.0
// Following rays allocates nothing.
#include "renderer/integrator.h"
#include "tests/images/allocations.h"
#include "tests/images/own_scenes.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

namespace lume::tests {
namespace {

class Allocations : public testing::TestWithParam<std::string> {};

std::size_t allocations_of_rays(const renderer::PreparedScene& prepared, const char* integrator) {
  constexpr std::uint32_t k_rays = 1000;
  const auto method = renderer::make_integrator(integrator, prepared,
                                                {.max_depth = 10, .occlusion_distance = 1.0f});
  const geometry::Camera& camera = prepared.scene().cameras.at(0);
  test::Random random(1);
  const std::size_t before = allocations();
  for (std::uint32_t i = 0; i < k_rays; ++i) {
    renderer::Ledger ledger;
    static_cast<void>(method->radiance(camera.generate_ray(random.square(), 1.5f),
                                       renderer::Sampler(1, 0, 0, i), ledger));
  }
  return allocations() - before;
}

TEST_P(Allocations, Rays_MakeNone) {
  shading::Scene scene = load_own_scene(GetParam());
  scene.environment = shading::studio_environment();
  scene.ambient = shading::Color(0.1f);
  const renderer::PreparedScene prepared(scene, "embree");
  ASSERT_GT(allocations(), 0u) << "loading makes some, and they are seen";
  static_cast<void>(allocations_of_rays(prepared, "whitted"));  // tables that are made on first use
  for (const char* integrator : {"whitted", "raycast"}) {
    EXPECT_EQ(allocations_of_rays(prepared, integrator), 0u) << integrator;
  }
}

INSTANTIATE_TEST_SUITE_P(Assets, Allocations, testing::ValuesIn(own_scene_names()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace lume::tests
