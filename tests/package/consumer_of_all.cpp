// SPDX-License-Identifier: Apache-2.0
// Uses something of every library, so that a dependency which LumeConfig forgets is missed here.
#include "io/color.h"
#include "lume_version.h"
#include "renderer/pixel_filter.h"
#include "shading/lights.h"

#include <cstdio>

int main() {
  const auto light = lume::shading::illuminate({}, {0.0f, 0.0f, -2.0f});
  const auto white = lume::io::tone_map_pbr_neutral(light.illuminance);
  std::printf("lume %s: %g\n", lume::k_version.data(), static_cast<double>(white.x));
  return lume::io::available_views().empty() ? 1 : 0;
}
