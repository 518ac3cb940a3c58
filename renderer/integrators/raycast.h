// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderer/integrator.h"

namespace lume::renderer {

[[nodiscard]] std::unique_ptr<Integrator> make_raycast(const PreparedScene& prepared,
                                                       const IntegratorSettings& settings);

}  // namespace lume::renderer
