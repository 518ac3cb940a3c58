// SPDX-License-Identifier: Apache-2.0
// An array for millions of nodes. It asks for pages of 2 MiB, because a traversal that jumps from
// page to page spends a tenth of its time on translating addresses otherwise.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace lume::geometry::wide {

/// Elements that are plain data, not initialised, in an array that does not grow.
template <class T>
class HugeArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  HugeArray() = default;
  /// Throws std::bad_alloc.
  explicit HugeArray(std::size_t size) : size_(size) {
    if (size == 0) return;
    const bool huge = memory_bytes() >= k_page;
    const std::size_t alignment = huge ? k_page : k_cache_line;
    const std::size_t bytes = (memory_bytes() + alignment - 1) / alignment * alignment;
    data_.reset(static_cast<T*>(std::aligned_alloc(alignment, bytes)));
    if (data_ == nullptr) throw std::bad_alloc();
    if (huge) madvise(data_.get(), bytes, MADV_HUGEPAGE);  // a wish, which may be refused
  }

  [[nodiscard]] const T* data() const { return data_.get(); }
  [[nodiscard]] T* data() { return data_.get(); }
  [[nodiscard]] const T& operator[](std::size_t i) const { return data_.get()[i]; }
  [[nodiscard]] T& operator[](std::size_t i) { return data_.get()[i]; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t memory_bytes() const { return size_ * sizeof(T); }

 private:
  static constexpr std::size_t k_page = std::size_t{1} << 21u;
  static constexpr std::size_t k_cache_line = 64;

  struct Free {
    void operator()(T* data) const { std::free(data); }
  };
  std::unique_ptr<T, Free> data_;
  std::size_t size_ = 0;
};

}  // namespace lume::geometry::wide
