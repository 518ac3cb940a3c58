// SPDX-License-Identifier: Apache-2.0
// What the builder of the kd-tree looks at instead of items: the places along each axis where one
// begins, ends, or lies as a whole. They are sorted once, at the root; what a plane parts stays in
// order, which makes O(N log N) of O(N log^2 N) (Wald and Havran 2006, "On building fast kd-Trees
// for Ray Tracing, and on doing that in O(N log N)").
#pragma once

#include "geometry/accelerators/items.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace lume::geometry::kd_tree {

/// In the order in which a sweep must see those at one place: what ends there is to the left of a
/// plane, what begins there to its right.
enum class EventKind : std::uint8_t { end, planar, start };

struct Event {
  float place = 0.0f;
  std::uint32_t item = 0;
  EventKind kind = EventKind::planar;

  bool operator<(const Event& other) const {
    if (place != other.place) return place < other.place;
    return kind != other.kind ? kind < other.kind : item < other.item;
  }
};

/// The items of a node, or the parts of them that are in its box.
struct EventLists {
  std::array<std::vector<Event>, 3> of_axis;  ///< each in order
  std::size_t count = 0;                      ///< of items

  /// What is in the box of an item, or of a part of it.
  void add(std::uint32_t item, const Bounds& box);
  void sort();
  [[nodiscard]] std::vector<std::uint32_t> items() const;
};

/// A plane across an axis, and to which side goes what lies in it.
struct Plane {
  int axis = 0;
  float place = 0.0f;
  bool planar_left = true;
};

/// The parts of a box on the two sides of a plane.
[[nodiscard]] std::pair<Bounds, Bounds> cut(const Bounds& box, const Plane& plane);

/// Parts the items of nodes. One for a whole tree: it has a note for each item.
class Divider {
 public:
  explicit Divider(const Items& items) : items_(items), sides_(items.size(), Side::both) {}

  /// What is on the two sides of a plane through a box; what it cuts is clipped to both.
  [[nodiscard]] std::pair<EventLists, EventLists> divide(EventLists events, const Bounds& box,
                                                         const Plane& plane);

 private:
  enum class Side : std::uint8_t { left, right, both };

  void find_sides(const std::vector<Event>& events, const Plane& plane);

  const Items& items_;
  std::vector<Side> sides_;  ///< `both` while no node is being divided
};

}  // namespace lume::geometry::kd_tree
