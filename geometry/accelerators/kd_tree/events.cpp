// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/kd_tree/events.h"

#include <algorithm>
#include <iterator>

namespace lume::geometry::kd_tree {
namespace {

/// Puts the events of two lists in order into the first.
void merge(EventLists& events, EventLists& more) {
  more.sort();
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Event>& list = events.of_axis[axis];
    const auto middle = static_cast<std::ptrdiff_t>(list.size());
    list.insert(list.end(), more.of_axis[axis].begin(), more.of_axis[axis].end());
    std::inplace_merge(list.begin(), list.begin() + middle, list.end());
  }
  events.count += more.count;
}

}  // namespace

void EventLists::add(std::uint32_t item, const Bounds& box) {
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Event>& list = of_axis[axis];
    if (box.lower[axis] == box.upper[axis]) {
      list.push_back({box.lower[axis], item, EventKind::planar});
    } else {
      list.push_back({box.lower[axis], item, EventKind::start});
      list.push_back({box.upper[axis], item, EventKind::end});
    }
  }
  ++count;
}

void EventLists::sort() {
  for (std::vector<Event>& list : of_axis) std::sort(list.begin(), list.end());
}

std::vector<std::uint32_t> EventLists::items() const {
  std::vector<std::uint32_t> result;
  result.reserve(count);
  for (const Event& event : of_axis[0]) {
    if (event.kind != EventKind::end) result.push_back(event.item);
  }
  return result;
}

std::pair<Bounds, Bounds> cut(const Bounds& box, const Plane& plane) {
  Bounds left = box;
  Bounds right = box;
  left.upper[plane.axis] = right.lower[plane.axis] = plane.place;
  return {left, right};
}

void Divider::find_sides(const std::vector<Event>& events, const Plane& plane) {
  for (const Event& event : events) {
    switch (event.kind) {
      case EventKind::end:
        if (event.place <= plane.place) sides_[event.item] = Side::left;
        break;
      case EventKind::start:
        if (event.place >= plane.place) sides_[event.item] = Side::right;
        break;
      case EventKind::planar: {
        const bool is_left =
            event.place != plane.place ? event.place < plane.place : plane.planar_left;
        sides_[event.item] = is_left ? Side::left : Side::right;
        break;
      }
    }
  }
}

std::pair<EventLists, EventLists> Divider::divide(EventLists events, const Bounds& box,
                                                  const Plane& plane) {
  find_sides(events.of_axis[plane.axis], plane);
  std::pair<EventLists, EventLists> whole;
  std::pair<EventLists, EventLists> parts;
  const auto [left_box, right_box] = cut(box, plane);
  for (int axis = 0; axis < 3; ++axis) {
    for (const Event& event : events.of_axis[axis]) {
      const Side side = sides_[event.item];
      const bool is_first = axis == 0 && event.kind != EventKind::end;
      if (side != Side::both) {
        EventLists& lists = side == Side::left ? whole.first : whole.second;
        lists.of_axis[axis].push_back(event);
        if (is_first) ++lists.count;
      } else if (is_first) {
        const Bounds left = items_.clipped(event.item, left_box);
        const Bounds right = items_.clipped(event.item, right_box);
        if (!left.is_empty()) parts.first.add(event.item, left);
        if (!right.is_empty()) parts.second.add(event.item, right);
      }
    }
  }
  for (const Event& event : events.of_axis[0]) sides_[event.item] = Side::both;
  events = {};  // before more memory is asked for
  merge(whole.first, parts.first);
  merge(whole.second, parts.second);
  return whole;
}

}  // namespace lume::geometry::kd_tree
