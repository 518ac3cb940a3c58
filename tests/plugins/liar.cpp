// SPDX-License-Identifier: Apache-2.0
// A plugin that lies, in the way that LUME_LIAR says.
#include <lume/accelerator_plugin.h>

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace {

bool lies(const char* how) {
  const char* wish = std::getenv("LUME_LIAR");
  return wish != nullptr && std::strcmp(wish, how) == 0;
}

void* build(const LumeTriangles*, char* message, std::size_t size) {
  if (lies("crash")) std::abort();
  if (lies("hang")) pause();
  if (lies("refuse")) {
    std::snprintf(message, size, "too tired");
    return nullptr;
  }
  return std::malloc(1);
}

int closest_hit(const void*, const LumeRay*, LumeHit* hit) {
  hit->triangle = lies("number") ? 1'000'000 : 0;
  hit->t = lies("nan") ? std::numeric_limits<float>::quiet_NaN() : 1.0f;
  return 1;
}

int any_hit(const void*, const LumeRay*) { return 1; }

void destroy(void* structure) { std::free(structure); }

}  // namespace

extern "C" const LumeAcceleratorPlugin* lume_accelerator_plugin(void) {
  static LumeAcceleratorPlugin plugin = {
      LUME_ACCELERATOR_PLUGIN_VERSION, "liar", build, closest_hit, any_hit, destroy, nullptr};
  if (lies("nothing")) return nullptr;
  plugin.version = lies("version") ? 99 : LUME_ACCELERATOR_PLUGIN_VERSION;
  return &plugin;
}
