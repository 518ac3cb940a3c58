// SPDX-License-Identifier: Apache-2.0
// Analytic shapes: what is read of them, and where they are drawn.
#include "io/error.h"
#include "tests/io/gltf_shape_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace lume::io {
namespace {

using geometry::DVec3;
using geometry::Shape;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const geometry::Geometry& first_geometry(const LoadedScene& loaded) {
  return loaded.scene.world.objects.at(0).geometries.at(0);
}

Shape load_shape(const nlohmann::json& shape) {
  return *first_geometry(test::load_json(test::shape_file(shape))).shape();
}

template <class Kind>
Kind load_as(const std::string& type, const nlohmann::json& parameters) {
  return std::get<Kind>(load_shape(test::shape_of(type, parameters)));
}

geometry::Bounds bounds_of(const Shape& shape) {
  return geometry::shape_bounds(shape, geometry::Transform());
}

void expect_bounds(const Shape& shape, const DVec3& lower, const DVec3& upper, double tolerance) {
  const geometry::Bounds bounds = bounds_of(shape);
  EXPECT_LE(length(DVec3(bounds.lower) - lower), tolerance) << bounds.lower.x << bounds.lower.y;
  EXPECT_LE(length(DVec3(bounds.upper) - upper), tolerance) << bounds.upper.x << bounds.upper.y;
}

TEST(GltfShape, WithoutParameters_HasDefaults) {
  EXPECT_EQ(std::get<geometry::Sphere>(load_shape({{"type", "sphere"}})).radius, 0.5);
  EXPECT_EQ(std::get<geometry::Box>(load_shape({{"type", "box"}})).half_size, DVec3(0.5));
  const auto cylinder = std::get<geometry::Cylinder>(load_shape({{"type", "cylinder"}}));
  EXPECT_EQ(cylinder.height, 0.5);
  EXPECT_EQ(cylinder.radius_bottom, 0.25);
  EXPECT_EQ(cylinder.radius_top, 0.25);
  expect_bounds(load_shape({{"type", "capsule"}}), {-0.25, -0.5, -0.25}, {0.25, 0.5, 0.25}, 1e-6);
  EXPECT_TRUE(std::isinf(std::get<geometry::Plane>(load_shape({{"type", "plane"}})).size_x));
  EXPECT_EQ(std::get<geometry::Disk>(load_shape({{"type", "LUME_disk"}})).radius, 0.5);
  const auto torus = std::get<geometry::Torus>(load_shape({{"type", "LUME_torus"}}));
  EXPECT_EQ(torus.major_radius, 0.375);
  EXPECT_EQ(torus.minor_radius, 0.125);
}

TEST(GltfShape, Parameters_ArriveUnchanged) {
  EXPECT_EQ(load_as<geometry::Sphere>("sphere", {{"radius", 0.1}}).radius, 0.1);
  EXPECT_EQ(load_as<geometry::Box>("box", {{"size", {1, 2, 3}}}).half_size, DVec3(0.5, 1, 1.5));
  const auto cone = load_as<geometry::Cylinder>(
      "cylinder", {{"height", 2}, {"radiusBottom", 0.7}, {"radiusTop", 0}});
  EXPECT_EQ(cone.height, 2.0);
  EXPECT_EQ(cone.radius_bottom, 0.7);
  EXPECT_EQ(cone.radius_top, 0.0);
  expect_bounds(load_shape(test::shape_of(
                    "capsule", {{"height", 2}, {"radiusBottom", 0.5}, {"radiusTop", 0.25}})),
                {-0.5, -1.5, -0.5}, {0.5, 1.25, 0.5}, 1e-6);
  const auto plane = load_as<geometry::Plane>("plane", {{"sizeX", 3}});
  EXPECT_EQ(plane.size_x, 3.0);
  EXPECT_TRUE(std::isinf(plane.size_z));
  const auto disk = load_as<geometry::Disk>("LUME_disk", {{"radius", 2}, {"innerRadius", 1}});
  EXPECT_EQ(disk.radius, 2.0);
  EXPECT_EQ(disk.inner_radius, 1.0);
  const auto torus =
      load_as<geometry::Torus>("LUME_torus", {{"majorRadius", 2}, {"minorRadius", 2}});
  EXPECT_EQ(torus.major_radius, 2.0);
  EXPECT_EQ(torus.minor_radius, 2.0);
}

/// F at a point, up to the positive factor that the reader may choose.
double ratio(const geometry::Quadric& quadric, const DVec3& p, const DVec3& reference) {
  return quadric.value(p) / quadric.value(reference);
}

TEST(GltfShape, QuadricCoefficients_AreTheUpperTriangle) {
  const std::vector<double> c = {3, 0.5, -0.25, 1, 5, 0.75, -2, 7, 0.125, -9};
  const auto quadric = load_as<geometry::Quadric>("LUME_quadric", {{"coefficients", c}});
  const auto expected = [&](const DVec3& p) {
    return c[0] * p.x * p.x + 2 * c[1] * p.x * p.y + 2 * c[2] * p.x * p.z + 2 * c[3] * p.x +
           c[4] * p.y * p.y + 2 * c[5] * p.y * p.z + 2 * c[6] * p.y + c[7] * p.z * p.z +
           2 * c[8] * p.z + c[9];
  };
  const DVec3 reference(5, -7, 11);
  for (const DVec3 p : {DVec3(0), DVec3(1, 0, 0), DVec3(0, 1, 0), DVec3(0, 0, 1), DVec3(1, 2, 3)}) {
    EXPECT_NEAR(ratio(quadric, p, reference), expected(p) / expected(reference), 1e-14);
  }
}

TEST(GltfShape, QuadricOfHugeCoefficients_IsStillTheSphere) {
  for (const double scale : {1e-300, 1e300, -1e300}) {
    const nlohmann::json parameters = {
        {"coefficients", {scale, 0, 0, 0, scale, 0, 0, scale, 0, -4 * scale}}};
    expect_bounds(load_shape(test::shape_of("LUME_quadric", parameters)), DVec3(-2), DVec3(2),
                  1e-5);
  }
}

TEST(GltfShape, QuadricForms_FillTheBoxOfTheirSemiAxes) {
  for (const char* form : {"ellipsoid", "cylinder", "cone", "paraboloid", "hyperboloidOneSheet",
                           "hyperboloidTwoSheets"}) {
    const nlohmann::json parameters = {{"form", form}, {"semiAxes", {1, 2, 3}}};
    SCOPED_TRACE(form);
    expect_bounds(load_shape(test::shape_of("LUME_quadric", parameters)), {-1, -2, -3}, {1, 2, 3},
                  0.1);
  }
}

TEST(GltfShape, QuadricClip_ReplacesTheAxesThatItNames) {
  const nlohmann::json parameters = {{"form", "cylinder"}, {"clip", {{"y", {-0.25, 3}}}}};
  expect_bounds(load_shape(test::shape_of("LUME_quadric", parameters)), {-0.5, -0.25, -0.5},
                {0.5, 3, 0.5}, 0.03);
  const nlohmann::json open = {{"coefficients", {1, 0, 0, 0, 0, 0, 0, 1, 0, -1}},
                               {"clip", {{"x", {0, 9}}}}};
  const geometry::Bounds bounds = bounds_of(load_shape(test::shape_of("LUME_quadric", open)));
  EXPECT_NEAR(bounds.lower.x, 0.0f, 0.02f);
  EXPECT_NEAR(bounds.upper.x, 1.0f, 0.02f);
  EXPECT_TRUE(std::isinf(bounds.lower.y) && std::isinf(bounds.upper.y));
}

TEST(GltfShape, QuadricCaps_CloseTheSolid) {
  // A ray along the axis of a cylinder: it meets nothing but the caps.
  const geometry::ObjectRay ray{{0, 5, 0}, {0, -1, 0}};
  for (const bool caps : {false, true}) {
    const nlohmann::json parameters = {{"form", "cylinder"}, {"caps", caps}};
    const Shape shape = load_shape(test::shape_of("LUME_quadric", parameters));
    const auto crossing = geometry::intersect(shape, ray);
    EXPECT_EQ(crossing.has_value(), caps);
    EXPECT_NEAR(crossing ? crossing->t : 4.5, 4.5, 1e-12);
  }
}

TEST(GltfShape, Polygon_HasItsHole) {
  const nlohmann::json parameters = nlohmann::json::parse(
      R"({"outline": [[0,0,1],[4,0,1],[4,4,1],[0,4,1]], "holes": [[[1,1,1],[1,3,1],[3,3,1]]]})");
  const Shape shape = load_shape(test::shape_of("LUME_polygon", parameters));
  expect_bounds(shape, {0, 0, 1}, {4, 4, 1}, 1e-5);
  const auto hit = [&](double x, double y) {
    return geometry::meets(shape, {{x, y, 9}, {0, 0, -1}});
  };
  EXPECT_TRUE(hit(0.5, 0.5));
  EXPECT_TRUE(hit(3, 1.5));
  EXPECT_FALSE(hit(1.5, 2.5));
  EXPECT_FALSE(hit(5, 5));
}

TEST(GltfShape, Polygon_FarAwayAndNearlyPlanar_IsRead) {
  // Rounded to single precision, a thousand kilometres out.
  nlohmann::json outline;
  for (int i = 0; i < 40; ++i) {
    const double angle = 0.05 * i * geometry::k_turn;
    const double x = 1e6 + 500 * std::cos(angle);
    const double z = 500 * std::sin(angle);
    outline.push_back(
        {static_cast<float>(x), static_cast<float>(0.3 * x - 0.7 * z), static_cast<float>(z)});
  }
  EXPECT_NO_THROW(load_shape(test::shape_of("LUME_polygon", {{"outline", outline}})));
}

TEST(GltfShape, Implicit_IsCutByItsBounds) {
  const nlohmann::json parameters = nlohmann::json::parse(
      R"({"expression": "x^2 + y^2 + z^2 - 1", "bounds": {"min": [-2,-2,-2], "max": [2,0,2]}})");
  expect_bounds(load_shape(test::shape_of("LUME_implicit", parameters)), {-1, -1, -1}, {1, 0, 1},
                0.05);
}

TEST(GltfShape, BezierPatches_TakeTheirPointsByIndex) {
  nlohmann::json points;
  nlohmann::json patch;
  for (int i = 15; i >= 0; --i) {  // backwards, so that the order is the indices'
    points.push_back({i % 4, 0.5 * i, i / 4});
    patch.push_back(i);
  }
  const auto surface = load_as<geometry::BezierSurface>(
      "LUME_bezier_patch", {{"points", points}, {"patches", {patch, patch}}});
  ASSERT_EQ(surface.patches().size(), 2u);
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(surface.patches()[1][static_cast<std::size_t>(4 * j + i)],
                DVec3(i, 0.5 * (4 * j + i), j));
    }
  }
}

TEST(GltfShape, CoreArray_IsReadLikeTheExtension) {
  nlohmann::json json = test::shape_file(nullptr);
  json["asset"]["version"] = "2.1";
  json.erase("extensions");
  json["shapes"] = nlohmann::json::array({test::shape_of("sphere", {{"radius", 3}})});
  const LoadedScene loaded = test::load_json(json);
  EXPECT_EQ(std::get<geometry::Sphere>(*first_geometry(loaded).shape()).radius, 3.0);
  EXPECT_THAT(loaded.notes, IsEmpty());
}

TEST(GltfShape, BothArrays_TheExtensionsCounts) {
  nlohmann::json json = test::shape_file(test::shape_of("sphere", {{"radius", 3}}));
  json["shapes"] = nlohmann::json::array({{{"type", "box"}}});
  const LoadedScene loaded = test::load_json(json);
  EXPECT_NE(std::get_if<geometry::Sphere>(first_geometry(loaded).shape()), nullptr);
  EXPECT_THAT(loaded.notes, ElementsAre(HasSubstr("KHR_implicit_shapes")));
}

TEST(GltfShape, UnknownType_IsNotedWhereNothingIsBoundToIt) {
  const nlohmann::json shapes = {{{"type", "sphere"}}, {{"type", "EXT_heightfield"}}};
  const LoadedScene loaded =
      test::load_json(test::shapes_file(shapes, nlohmann::json::array({test::shape_node(0)})));
  EXPECT_THAT(loaded.notes, ElementsAre(HasSubstr("shape 1: its type 'EXT_heightfield'")));
  EXPECT_THROW(
      test::load_json(test::shapes_file(shapes, nlohmann::json::array({test::shape_node(1)}))),
      Error);
}

TEST(GltfShape, UnknownParameter_IsNotedWithTheNearest) {
  const LoadedScene loaded = test::load_json(test::shape_file(
      test::shape_of("sphere", {{"raduis", 2}, {"extras", 1}, {"extensions", {{"A", 1}}}})));
  EXPECT_THAT(loaded.notes, ElementsAre(HasSubstr("did you mean radius?")));
  EXPECT_EQ(std::get<geometry::Sphere>(*first_geometry(loaded).shape()).radius, 0.5);
}

}  // namespace
}  // namespace lume::io
