// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace lume::tests {

/// How often this thread has called operator new so far.
[[nodiscard]] std::size_t allocations();

}  // namespace lume::tests
