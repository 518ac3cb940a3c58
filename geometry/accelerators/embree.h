// SPDX-License-Identifier: Apache-2.0
// Intel Embree 3 behind the Accelerator interface. All that is peculiar to Embree, its version
// included, stays in embree.cpp and embree_callbacks. The environment variable LUME_EMBREE_CONFIG
// is handed to rtcNewDevice ("max_isa=sse4.2" lowers the instruction set).
#pragma once

#include <string>

namespace lume::geometry {

/// Version of the Embree library that is loaded, "3.13.5".
[[nodiscard]] std::string embree_version();

}  // namespace lume::geometry
