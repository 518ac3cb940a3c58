// SPDX-License-Identifier: Apache-2.0
// docs/shapes.md and docs/schema say what the reader does.
#include "io/error.h"
#include "io/gltf/shape_types.h"
#include "tests/io/gltf_shape_file.h"
#include "tests/support/shape_examples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace lume::io {
namespace {

using gltf::ShapeType;
using nlohmann::json;

TEST(ShapesPage, EveryExample_LoadsWithoutNotes) {
  const std::vector<json> examples = test::shape_examples();
  EXPECT_GE(examples.size(), gltf::shape_types().size());
  for (const json& example : examples) {
    const LoadedScene loaded = test::load_json(example);
    EXPECT_EQ(loaded.scene.world.instances.size(), example.at("nodes").size()) << example;
    EXPECT_THAT(loaded.notes, testing::IsEmpty()) << example;
    for (const geometry::Object& object : loaded.scene.world.objects) {
      EXPECT_NE(object.geometries.at(0).shape(), nullptr) << example;
    }
  }
}

TEST(ShapesPage, OctahedronOfThePage_IsDrawnWhenAskedFor) {
  const LoadedScene loaded = test::load_json(test::shape_examples().at(1), test::tessellated());
  const geometry::Mesh* mesh = loaded.scene.world.objects.at(0).geometries.at(0).mesh();
  ASSERT_NE(mesh, nullptr);
  EXPECT_EQ(mesh->triangles.size(), 8u);
}

TEST(ShapesPage, EveryTypeAndParameter_IsThere) {
  const std::string page = test::read_text(tests::source_dir() / "docs/shapes.md");
  std::set<std::string> shown;
  for (const json& shape : test::example_shapes()) shown.insert(shape.at("type"));
  for (const ShapeType& type : gltf::shape_types()) {
    const std::string name(type.name);
    EXPECT_EQ(shown.count(name), 1u) << name;
    EXPECT_NE(page.find(std::string("\n### ").append(name).append("\n")), std::string::npos)
        << name;
    for (const std::string_view property : type.properties) {
      EXPECT_NE(page.find(std::string("`").append(property).append("`")), std::string::npos)
          << property;
    }
  }
}

/// Lume's own types, which have a schema.
std::vector<ShapeType> vendor_types() {
  std::vector<ShapeType> types;
  for (const ShapeType& type : gltf::shape_types()) {
    if (type.name.starts_with("LUME_")) types.push_back(type);
  }
  return types;
}

TEST(ShapeSchema, EachTypeOfOurOwn_HasOneWithItsProperties) {
  EXPECT_EQ(vendor_types().size(), 6u);
  for (const ShapeType& type : vendor_types()) {
    const json schema = test::load_schema(std::string(type.name)).json();
    EXPECT_EQ(schema.at("$schema"), "https://json-schema.org/draft/2020-12/schema");
    EXPECT_EQ(schema.at("$id"), std::string(type.name) + ".schema.json");
    std::vector<std::string> properties;
    for (const auto& property : schema.at("properties").items()) {
      properties.push_back(property.key());
    }
    EXPECT_THAT(properties, testing::ElementsAreArray(type.properties)) << type.name;
    EXPECT_EQ(type.needs_parameters, schema.contains("required") || schema.contains("oneOf"));
  }
}

/// What can be told of a shape from outside: its bounds, and what some rays meet.
std::vector<double> fingerprint(const json& shape) {
  const LoadedScene loaded = test::load_json(test::shape_file(shape));
  const geometry::Shape& surface = *loaded.scene.world.objects.at(0).geometries.at(0).shape();
  const geometry::Bounds bounds = geometry::shape_bounds(surface, geometry::Transform());
  std::vector<double> result = {bounds.lower.x, bounds.lower.y, bounds.lower.z,
                                bounds.upper.x, bounds.upper.y, bounds.upper.z};
  for (int i = 0; i < 100; ++i) {
    const geometry::DVec3 target(0.01 * i - 0.5, 0.1 * (i % 10) - 0.45, 0.07 * (i % 7) - 0.2);
    const geometry::DVec3 origin(5 - i % 3, 4, 1 + i % 5);
    const auto crossing = geometry::intersect(surface, {origin, target - origin});
    result.push_back(crossing ? crossing->t : -1.0);
  }
  return result;
}

TEST(ShapeSchema, Defaults_AreThoseOfTheReader) {
  const json forms = {{"LUME_disk", {{}}},
                      {"LUME_torus", {{}}},
                      {"LUME_quadric", {{{"form", "hyperboloidOneSheet"}}}},
                      {"LUME_polygon", {{{"outline", {{0, 0, 0}, {1, 0, 0}, {0, 0, -1}}}}}}};
  int defaults = 0;
  for (const auto& [type, list] : forms.items()) {
    const json parameters = list.at(0).is_null() ? json::object() : list.at(0);
    const json schema = test::load_schema(type).json();
    const std::vector<double> expected = fingerprint(test::shape_of(type, parameters));
    for (const auto& [key, property] : schema.at("properties").items()) {
      if (!property.contains("default")) continue;
      json with_default = parameters;
      with_default[key] = property.at("default");
      EXPECT_EQ(fingerprint(test::shape_of(type, with_default)), expected) << type << ' ' << key;
      ++defaults;
    }
  }
  EXPECT_EQ(defaults, 8);
}

TEST(ShapeSchema, EveryExample_IsAccepted) {
  for (const json& shape : test::example_shapes()) {
    const std::string type = shape.at("type");
    if (!type.starts_with("LUME_")) continue;
    EXPECT_TRUE(test::load_schema(type).accepts(shape.at(type))) << shape;
  }
  for (const json& example : test::shape_examples()) {
    for (const json& node : example.at("nodes")) {
      if (!node.contains("extensions")) continue;
      const json& binding = node.at("extensions").at("LUME_shape");
      EXPECT_TRUE(test::load_schema("LUME_shape.node").accepts(binding)) << binding;
    }
  }
  EXPECT_TRUE(test::load_schema("LUME_shape.primitive").accepts({{"shape", 0}}));
  EXPECT_FALSE(test::load_schema("LUME_shape.primitive").accepts({{"shape", -1}}));
  EXPECT_FALSE(test::load_schema("LUME_shape.node").accepts({{"material", 0}}));
}

bool reader_accepts(const json& shape) {
  try {
    static_cast<void>(test::load_json(test::shape_file(shape)));
    return true;
  } catch (const Error&) {
    return false;
  }
}

TEST(ShapeSchema, WhatItRefuses_TheReaderRefuses) {
  // Each value within the examples in turn becomes each of these, or goes.
  const std::vector<json> others = {
      nullptr, true, 0, -1, 1e-16, 1.5, 2e15, "cone", "x+y-z", json::array(), json::object()};
  int refused = 0;
  for (const json& shape : test::example_shapes()) {
    const std::string type = shape.at("type");
    if (!type.starts_with("LUME_")) continue;
    const test::JsonSchema schema = test::load_schema(type);
    const auto try_out = [&](const json& changed) {
      if (schema.accepts(changed)) return;
      EXPECT_FALSE(reader_accepts(test::shape_of(type, changed))) << changed;
      ++refused;
    };
    std::set<std::string> places;
    const json flat = shape.at(type).flatten();
    for (const auto& leaf : flat.items()) {
      for (json::json_pointer at(leaf.key()); !at.empty(); at = at.parent_pointer()) {
        places.insert(at.to_string());
      }
    }
    for (const std::string& place : places) {
      for (const json& other : others) {
        json changed = shape.at(type);
        changed[json::json_pointer(place)] = other;
        try_out(changed);
      }
      try_out(shape.at(type).patch(json::array({{{"op", "remove"}, {"path", place}}})));
    }
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace lume::io
