// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/accelerators/zbuffer/scene_items.h"
#include "geometry/accelerators/zbuffer/tile.h"

#include <atomic>
#include <optional>
#include <span>
#include <vector>

namespace lume::geometry::zbuffer {

/// So many of something may be stored, all threads together. Whether that is enough does not depend
/// on who comes first.
class Allowance {
 public:
  explicit Allowance(std::size_t count) : left_(static_cast<std::int64_t>(count)) {}

  void take(std::size_t count) {
    left_.fetch_sub(static_cast<std::int64_t>(count), std::memory_order_relaxed);
  }
  [[nodiscard]] bool is_overdrawn() const { return left_.load(std::memory_order_relaxed) < 0; }

 private:
  std::atomic<std::int64_t> left_;
};

/// Which items touch which tile.
class TileLists {
 public:
  /// None if there are more than `most` entries.
  [[nodiscard]] static std::optional<TileLists> sort(const SceneItems& items, const View& view,
                                                     std::size_t most);

  /// In ascending order.
  [[nodiscard]] std::span<const std::uint32_t> items(std::size_t tile) const {
    return std::span(items_).subspan(first_[tile], first_[tile + 1] - first_[tile]);
  }

 private:
  std::vector<std::size_t> first_;  ///< entry of each tile, and behind the last
  std::vector<std::uint32_t> items_;
};

}  // namespace lume::geometry::zbuffer
