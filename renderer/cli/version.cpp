// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/version.h"

#include "geometry/accelerators/embree.h"
#include "lume_version.h"

#include <OpenColorIO/OpenColorIO.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <oneapi/tbb/version.h>
#include <spdlog/version.h>
#include <CLI/Version.hpp>
#include <glm/detail/setup.hpp>
#include <nlohmann/json.hpp>

namespace lume::cli {
namespace {

std::string dotted(long major, long minor, long patch) {
  return fmt::format("{}.{}.{}", major, minor, patch);
}

}  // namespace

std::vector<LibraryVersion> library_versions() {
  const int oiio = OIIO::openimageio_version();  // major * 10000 + minor * 100 + patch
  return {
      {"Embree", geometry::embree_version()},
      {"oneTBB", TBB_runtime_version()},
      {"tinygltf", LUME_TINYGLTF_VERSION},
      {"OpenImageIO", dotted(oiio / 10000, oiio / 100 % 100, oiio % 100)},
      {"OpenColorIO", OCIO_NAMESPACE::GetVersion()},
      {"glm", dotted(GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH) +
                  fmt::format(".{}", GLM_VERSION_REVISION)},
      {"fmt", dotted(FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"spdlog", dotted(SPDLOG_VER_MAJOR, SPDLOG_VER_MINOR, SPDLOG_VER_PATCH)},
      {"CLI11", CLI11_VERSION},
      {"nlohmann-json", dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                               NLOHMANN_JSON_VERSION_PATCH)},
  };
}

std::string instruction_set() {
  // Embree chooses in this order; its AVX-512 code needs all of these (Skylake's set).
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512vl")) {
    return "AVX-512";
  }
  if (__builtin_cpu_supports("avx2")) return "AVX2";
  if (__builtin_cpu_supports("avx")) return "AVX";
  return __builtin_cpu_supports("sse4.2") ? "SSE4.2" : "SSE2";
}

std::string version_text() {
  std::string text = fmt::format("lume {}\n", k_version);
  for (const LibraryVersion& library : library_versions()) {
    text += fmt::format("  {:<18}{}\n", library.name, library.version);
  }
  return text + fmt::format("  {:<18}{}\n", "instruction set", instruction_set());
}

}  // namespace lume::cli
