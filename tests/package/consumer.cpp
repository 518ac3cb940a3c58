// SPDX-License-Identifier: Apache-2.0
// A ray at a triangle, through installed headers and libraries alone. Exit code 0: it was met.
#include "geometry/accelerators/accelerator.h"
#include "geometry/world.h"

#include <cstdio>

int main() {
  using namespace lume::geometry;

  Mesh mesh;
  mesh.positions = {{-1.0f, -1.0f, -2.0f}, {1.0f, -1.0f, -2.0f}, {0.0f, 1.0f, -2.0f}};
  mesh.triangles = {{0, 1, 2}};
  World world;
  world.objects = {{"triangle", {{mesh}}}};
  world.instances = {{"only", 0, Transform()}};

  const auto accelerator = make_accelerator("embree", world, nullptr);
  const bool met = accelerator->closest_hit(Ray{}) == Hit{0, 0, 0};
  const bool missed = !accelerator->closest_hit({.origin = {3.0f, 0.0f, 0.0f}});
  std::printf("met: %d, missed beside it: %d\n", met, missed);
  return met && missed ? 0 : 1;
}
