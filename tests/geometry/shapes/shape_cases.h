// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/geometry/shapes/referee.h"

#include <vector>

namespace lume::geometry {

/// Every shape that has a closed form, with its oracle: whole, tapered, cut, degenerate, tiny and
/// huge.
[[nodiscard]] std::vector<ShapeCase> closed_form_cases();

}  // namespace lume::geometry
