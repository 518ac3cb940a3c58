// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/items.h"

#include "geometry/accelerators/clip_triangle.h"

#include <cmath>
#include <limits>

namespace lume::geometry {
namespace {

float float_below(double x) {
  return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
}

Bounds outwards(const DBounds& bounds) {
  Bounds result;
  for (int i = 0; i < 3; ++i) {
    result.lower[i] = float_below(bounds.lower[i]);
    result.upper[i] = -float_below(-bounds.upper[i]);
  }
  return result;
}

/// Around the corners of a box in the scene's frame, and around all that rounding may do to what is
/// inside on its way there.
Bounds placed_bounds(const Bounds& bounds, const Transform& transform) {
  const DVec3 farthest(glm::max(glm::abs(bounds.lower), glm::abs(bounds.upper)));
  const DMat3& linear = transform.linear();
  const DVec3 size = glm::abs(linear[0]) * farthest.x + glm::abs(linear[1]) * farthest.y +
                     glm::abs(linear[2]) * farthest.z + glm::abs(transform.translation());
  constexpr double k_rounding = 1e-14;  // some tens of roundings
  DBounds result;
  for (int corner = 0; corner < 8; ++corner) {
    result.add(transform.point_to_world({(corner & 1) != 0 ? bounds.upper.x : bounds.lower.x,
                                         (corner & 2) != 0 ? bounds.upper.y : bounds.lower.y,
                                         (corner & 4) != 0 ? bounds.upper.z : bounds.lower.z}));
  }
  result.lower -= k_rounding * size;
  result.upper += k_rounding * size;
  return outwards(result);
}

/// False where a structure in float might compute what is not a number.
bool can_sort(const Bounds& bounds) {
  constexpr float k_farthest = 1e17f;
  const Vec3 size = glm::max(glm::abs(bounds.lower), glm::abs(bounds.upper));
  return size.x <= k_farthest && size.y <= k_farthest && size.z <= k_farthest;
}

std::size_t triangle_count(const Object& object) {
  std::size_t count = 0;
  for (const Geometry& geometry : object.geometries) {
    if (geometry.mesh() != nullptr) count += geometry.mesh()->triangles.size();
  }
  return count;
}

}  // namespace

Bounds Items::all_bounds() const {
  Bounds result;
  for (const Bounds& bounds : bounds_) result.add(bounds);
  return result;
}

Bounds Items::clipped(std::uint32_t i, const Bounds& box) const {
  const Bounds cut{glm::max(bounds_[i].lower, box.lower), glm::min(bounds_[i].upper, box.upper)};
  const bool overlaps = glm::all(glm::lessThanEqual(cut.lower, cut.upper));
  return overlaps ? cut : Bounds();
}

void Items::add_points(std::uint32_t i, std::vector<Vec3>& points) const {
  const Bounds& box = bounds_[i];
  for (int corner = 0; corner < 8; ++corner) {
    points.emplace_back((corner & 1) != 0 ? box.upper.x : box.lower.x,
                        (corner & 2) != 0 ? box.upper.y : box.lower.y,
                        (corner & 4) != 0 ? box.upper.z : box.lower.z);
  }
}

std::vector<std::uint32_t> unmoved_instances(const World& world) {
  std::vector<std::uint32_t> uses(world.objects.size());
  for (const Instance& instance : world.instances) ++uses[instance.object];
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = 0; i < world.instances.size(); ++i) {
    const Instance& instance = world.instances[i];
    const bool is_unmoved =
        instance.transform.linear() == DMat3(1.0) && instance.transform.translation() == DVec3(0.0);
    if (is_unmoved && uses[instance.object] == 1) result.push_back(i);
  }
  return result;
}

TriangleItems::TriangleItems(const Object& object) {
  reserve(triangle_count(object));
  add(object, 0);
}

TriangleItems::TriangleItems(const World& world, const std::vector<std::uint32_t>& instances) {
  std::size_t count = 0;
  for (const std::uint32_t i : instances) {
    count += triangle_count(world.objects[world.instances[i].object]);
  }
  reserve(count);
  for (const std::uint32_t i : instances) add(world.objects[world.instances[i].object], i);
}

void TriangleItems::reserve(std::size_t count) {
  bounds_.reserve(count);
  identities_.reserve(count);
  meshes_.reserve(count);
}

void TriangleItems::add(const Object& object, std::uint32_t instance) {
  Hit id{instance, 0, 0};
  for (id.geometry = 0; id.geometry < object.geometries.size(); ++id.geometry) {
    const Mesh* mesh = object.geometries[id.geometry].mesh();
    if (mesh == nullptr) continue;
    for (id.primitive = 0; id.primitive < mesh->triangles.size(); ++id.primitive) {
      const auto corners = mesh->corners(id.primitive);
      if (!is_finite(corners[0]) || !is_finite(corners[1]) || !is_finite(corners[2])) continue;
      Bounds bounds;
      for (const Vec3& corner : corners) bounds.add(corner);
      bounds_.push_back(bounds);
      identities_.push_back(id);
      meshes_.push_back(mesh);
    }
  }
}

Bounds TriangleItems::clipped(std::uint32_t i, const Bounds& box) const {
  return clip_triangle(corners(i), Items::clipped(i, box));
}

void TriangleItems::add_points(std::uint32_t i, std::vector<Vec3>& points) const {
  for (const Vec3& corner : corners(i)) points.push_back(corner);
}

PlacementItems::PlacementItems(const World& world, const std::vector<Bounds>& of_triangles) {
  const auto add = [this](const Placement& placement, const Bounds& bounds) {
    if (can_sort(bounds)) bounds_.push_back(bounds);
    (can_sort(bounds) ? placements_ : endless_).push_back(placement);
  };
  for (std::uint32_t i = 0; i < world.instances.size(); ++i) {
    const auto& [name, object, transform] = world.instances[i];
    if (!of_triangles[object].is_empty()) {
      add({i, std::nullopt}, placed_bounds(of_triangles[object], transform));
    }
    const std::vector<Geometry>& geometries = world.objects[object].geometries;
    for (std::uint32_t g = 0; g < geometries.size(); ++g) {
      if (geometries[g].shape() == nullptr) continue;
      add({i, g}, shape_bounds(*geometries[g].shape(), transform));
    }
  }
}

}  // namespace lume::geometry
