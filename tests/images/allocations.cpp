// SPDX-License-Identifier: Apache-2.0
// The program's operator new, counted. In a file of its own, so that no caller sees through it.
#include "tests/images/allocations.h"

#include <cstdlib>
#include <new>

namespace {

thread_local std::size_t count = 0;

}  // namespace

// The other forms that the standard library has, for arrays and so on, all call these.
void* operator new(std::size_t size) {
  ++count;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }

namespace lume::tests {

std::size_t allocations() { return count; }

}  // namespace lume::tests
