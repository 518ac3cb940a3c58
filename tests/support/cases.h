// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace lume::test {

/// How many random cases to try where that takes seconds. Sanitizers look for other mistakes than
/// wrong numbers, at a fraction of the speed, and get a tenth.
constexpr int cases(int count) { return LUME_SANITIZED ? count / 10 : count; }

}  // namespace lume::test
