// SPDX-License-Identifier: Apache-2.0
// What the z-buffer says about rectangles of the picture, against rays through them.
#include "geometry/accelerators/zbuffer/projector.h"
#include "geometry/refine.h"
#include "tests/support/cases.h"
#include "tests/support/random.h"
#include "tests/support/worlds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::geometry {
namespace {

using test::Random;
using zbuffer::CellRange;
using zbuffer::Rect;
using zbuffer::View;

constexpr int k_width = 60;
constexpr int k_height = 40;

Camera random_camera(Random& random) {
  Camera camera = look_at(random.cube(5.0f), random.cube(5.0f), random.uniform(0.2f, 2.0f));
  if (random.below(2) == 0) camera.projection = Camera::Projection::orthographic;
  camera.half_height = random.uniform(0.5f, 5.0f);
  return camera;
}

/// Through a random place of a cell, or its corner; border cells included.
Ray ray_through(Random& random, const Camera& camera, const glm::ivec2& cell) {
  const Vec2 size(k_width, k_height);
  const Vec2 inside = random.below(4) == 0 ? Vec2(0.0f) : random.square();
  const Vec2 place = Vec2(cell - View::k_border) + inside;
  return camera.generate_ray(place / size, size.x / size.y);
}

TEST(ZBufferView, RaysOfTheCamera_AreInTheirPixels) {
  Random random(1);
  for (int i = 0; i < test::cases(20000); ++i) {
    const Camera camera = random_camera(random);
    const View view(camera, k_width, k_height);
    EXPECT_EQ(view.size(), glm::ivec2(k_width + 2 * View::k_border, k_height + 2 * View::k_border));
    const Vec2 size(k_width, k_height);
    const Vec2 pixel = random.square() * (size + 6.0f) - 3.0f;
    const auto found = view.find(camera.generate_ray(pixel / size, size.x / size.y));
    ASSERT_TRUE(found);
    const glm::dvec2 inside = glm::dvec2(pixel) + double{View::k_border} - glm::dvec2(found->cell);
    EXPECT_GT(std::min(inside.x, inside.y), -1e-3);  // of a pixel, as the camera has it in floats
    EXPECT_LT(std::max(inside.x, inside.y), 1.0 + 1e-3);
  }
}

TEST(ZBufferView, DepthOfARay_IsItsWayAlongTheAxis) {
  Random random(2);
  for (int i = 0; i < test::cases(5000); ++i) {
    const Camera camera = random_camera(random);
    const View view(camera, k_width, k_height);
    const Ray ray = ray_through(random, camera, {20, 20});
    const auto found = view.find(ray);
    ASSERT_TRUE(found);
    const float t = random.uniform(0.1f, 20.0f);
    const double unit = view.is_perspective() ? 1.0 : static_cast<double>(camera.half_height);
    EXPECT_NEAR(unit * found->depth(t), camera.depth(ray.origin + t * ray.direction), 1e-4);
  }
}

TEST(ZBufferView, RaysThatAreNotTheCameras_AreNotFound) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Camera camera = random_camera(random);
    const View view(camera, k_width, k_height);
    Ray ray = ray_through(random, camera, {20, 20});
    EXPECT_TRUE(view.find(ray));
    Ray other = ray;
    other.t_min = 1e-3f;
    EXPECT_FALSE(view.find(other));
    other = ray;
    if (view.is_perspective()) {
      other.origin.x += 1e-3f;
    } else {
      other.direction.x += 1e-3f;
    }
    EXPECT_FALSE(view.find(other));
    EXPECT_FALSE(view.find(ray_through(random, camera, {-2, 20})));
    EXPECT_FALSE(view.find(ray_through(random, camera, {20, k_height + 2 * View::k_border + 1})));
    other = ray;
    other.direction = -ray.direction;
    EXPECT_FALSE(view.find(other));
  }
}

/// A triangle of any size, anywhere around the camera, in the space of some instance.
struct Placed {
  explicit Placed(Random& random) : transform(test::random_transform(random, 3.0f)) {
    const float size = std::exp2(random.uniform(-6.0f, 3.0f));
    const Vec3 center = random.cube(4.0f);
    for (Vec3& corner : corners) {
      corner = Vec3(transform.point_to_object(DVec3(center + size * random.cube(1.0f))));
    }
  }

  [[nodiscard]] std::optional<double> meet(const Ray& ray) const {
    const ObjectRay object_ray = to_object(transform, ray);
    const ShearedRay sheared(object_ray.origin, object_ray.direction);
    const TriangleCrossing crossing =
        intersect_triangle(sheared, DVec3(corners[0]), DVec3(corners[1]), DVec3(corners[2]));
    if (!crossing.inside || !object_ray.contains(crossing.t)) return std::nullopt;
    return crossing.t;
  }

  Transform transform;
  std::array<Vec3, 3> corners{};
};

struct Counts {
  int hits = 0;
  int covers = 0;
  int beside = 0;  ///< rectangles within the bounds that the triangle does not touch
};

/// A rectangle of a few cells, and rays through it.
void check_rectangle(Random& random, const Camera& camera, const View& view, const Placed& placed,
                     Counts& counts) {
  const auto below = [&random](int n) {
    return static_cast<int>(random.below(static_cast<unsigned>(n)));
  };
  const glm::ivec2 first(below(view.size().x), below(view.size().y));
  const int side = 1 + below(3);
  const CellRange cells{first, glm::min(first + side, view.size())};
  const Rect rect = view.rect(cells);
  const auto footprint = zbuffer::Projector(view, placed.transform).triangle(placed.corners, false);
  const CellRange seen = footprint ? view.touched_by(footprint->bounds) : CellRange();
  const bool in_bounds = glm::all(glm::lessThan(cells.first, seen.last)) &&
                         glm::all(glm::lessThan(seen.first, cells.last));
  const bool touches = in_bounds && footprint->touches(rect);
  const bool covers = in_bounds && footprint->covers(rect);
  counts.covers += covers ? 1 : 0;
  counts.beside += in_bounds && !touches ? 1 : 0;
  for (int i = 0; i < 8; ++i) {
    const glm::ivec2 size = cells.last - cells.first;
    const Ray ray =
        ray_through(random, camera, cells.first + glm::ivec2(below(size.x), below(size.y)));
    const auto in_view = view.find(ray);
    const bool is_inside = in_view && glm::all(glm::greaterThanEqual(in_view->cell, cells.first)) &&
                           glm::all(glm::lessThan(in_view->cell, cells.last));
    if (!is_inside) continue;  // by a rounding in the camera
    const auto t = placed.meet(ray);
    EXPECT_TRUE(t || !covers);
    if (!t) continue;
    ++counts.hits;
    ASSERT_TRUE(touches);
    const double depth = in_view->depth(*t);
    const double nearness = view.is_perspective() ? 1.0 / depth : -depth;
    EXPECT_LE(nearness, footprint->nearest(rect));
    EXPECT_TRUE(!covers || nearness >= footprint->farthest(rect));
  }
}

TEST(ZBufferFootprint, RaysThroughRectangles_MeetWhatItSays) {
  Random random(4);
  Counts counts;
  for (int i = 0; i < test::cases(150000) && !HasFailure(); ++i) {
    const Camera camera = random_camera(random);
    const View view(camera, k_width, k_height);
    const Placed placed(random);
    SCOPED_TRACE(i);
    for (int k = 0; k < 4; ++k) check_rectangle(random, camera, view, placed, counts);
  }
  EXPECT_GT(counts.hits, test::cases(30000));
  EXPECT_GT(counts.covers, test::cases(2500));
  EXPECT_GT(counts.beside, test::cases(5000));
}

TEST(ZBufferFootprint, TriangleBeforeTheCamera_IsBoundedTightly) {
  // A right triangle of one unit, one unit before a camera that sees two units of height there.
  Camera camera;
  camera.vertical_fov = 2.0f * std::atan(1.0f);
  const View view(camera, 40, 40);
  const zbuffer::Projector projector(view, Transform());
  const auto footprint =
      projector.triangle({Vec3(0, 0, -1), Vec3(0.5f, 0, -1), Vec3(0, 0.5f, -1)}, false);
  ASSERT_TRUE(footprint);
  // Up is towards row 0; the middle is at 24 cells, border included, and half a unit is 10.
  const CellRange cells = view.touched_by(footprint->bounds);
  EXPECT_EQ(cells.first, glm::ivec2(23, 13));
  EXPECT_EQ(cells.last, glm::ivec2(35, 25));
  EXPECT_TRUE(footprint->covers(view.rect({{25, 21}, {26, 22}})));
  EXPECT_FALSE(footprint->covers(view.rect({{32, 15}, {33, 16}})));
  EXPECT_FALSE(footprint->touches(view.rect({{32, 15}, {33, 16}})));
  const Rect middle = view.rect({{25, 21}, {26, 22}});
  EXPECT_NEAR(footprint->nearest(middle), 1.0, 1e-9);
  EXPECT_NEAR(footprint->farthest(middle), 1.0, 1e-9);
  EXPECT_FALSE(projector.triangle({Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1)}, false));
}

TEST(ZBufferFootprint, PointsInBoxes_AreInTheirBounds) {
  Random random(5);
  for (int i = 0; i < test::cases(20000); ++i) {
    const Camera camera = random_camera(random);
    const View view(camera, k_width, k_height);
    Bounds box;
    box.add(random.cube(5.0f));
    box.add(box.lower + random.cube(2.0f));
    const auto footprint = zbuffer::Projector(view, Transform()).box(box);
    const CellRange seen = footprint ? view.touched_by(footprint->bounds) : CellRange();
    const Ray ray = ray_through(random, camera, {static_cast<int>(random.below(60)), 20});
    const auto in_view = view.find(ray);
    if (!in_view) continue;
    for (int k = 0; k < 10; ++k) {
      const float t = random.uniform(0.0f, 8.0f);
      const Vec3 point = ray.origin + t * ray.direction;
      if (!box.contains(point)) continue;
      ASSERT_TRUE(footprint);
      EXPECT_TRUE(glm::all(glm::lessThan(in_view->cell, seen.last)));
      EXPECT_TRUE(glm::all(glm::greaterThanEqual(in_view->cell, seen.first)));
      const double depth = in_view->depth(t);
      EXPECT_LE((view.is_perspective() ? 1.0 / depth : -depth) - 1e-4, footprint->nearest_corner);
    }
  }
}

}  // namespace
}  // namespace lume::geometry
