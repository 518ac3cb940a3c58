// SPDX-License-Identifier: Apache-2.0
// docs/phong.md and its schemas in docs/schema say what the reader does; and no change to the
// page's examples makes the reader do anything but load or refuse them.
#include "io/error.h"
#include "tests/io/gltf_shape_file.h"
#include "tests/support/random.h"
#include "tests/support/shape_examples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace lume::io {
namespace {

using nlohmann::json;
using testing::IsEmpty;

/// An extension at one of its places: the schema's name, and where it goes in host_file().
struct Place {
  const char* schema;
  const char* pointer;
};

constexpr Place k_places[] = {
    {"LUME_materials_phong.material", "/materials/0/extensions/LUME_materials_phong"},
    {"LUME_materials_phong.light",
     "/extensions/KHR_lights_punctual/lights/0/extensions/LUME_materials_phong"},
    {"LUME_materials_phong.scene", "/scenes/0/extensions/LUME_materials_phong"},
    {"LUME_texture_checker", "/textures/0/extensions/LUME_texture_checker"},
};

std::vector<json> page_examples() { return test::page_examples("phong.md"); }

/// A file that has this in one of the places.
json file_with(const Place& place, const json& extension) {
  static const json k_host = test::triangle_file().complete();
  json file = k_host;
  file[json::json_pointer(place.pointer)] = extension;
  return file;
}

/// What the examples have at the place.
std::vector<json> page_values(const Place& place) {
  std::vector<json> values;
  for (const json& example : page_examples()) {
    const json::json_pointer pointer(place.pointer);
    if (example.contains(pointer)) values.push_back(example.at(pointer));
  }
  return values;
}

/// Everything that the extensions can change.
std::vector<double> fingerprint(const shading::Scene& scene) {
  const shading::Material& material = scene.materials.at(0);
  const shading::Phong phong = material.phong.value_or(shading::Phong{});
  const shading::Checker checker = scene.textures.at(0).checker.value_or(shading::Checker{});
  const shading::Color background = scene.background.value_or(shading::Color(-1.0f));
  const shading::Vec3 attenuation = scene.lights.at(0).attenuation.value_or(shading::Vec3(-1.0f));
  std::vector<double> result = {phong.ambient,      phong.diffuse,    phong.specular,
                                phong.shininess,    phong.reflection, phong.glossiness,
                                phong.transmission, material.ior,     phong.fresnel ? 1.0 : 0.0,
                                checker.checks.x,   checker.checks.y};
  for (const shading::Vec3& color :
       {phong.ambient_color, phong.diffuse_color, phong.specular_color, phong.transmission_color,
        scene.ambient, background, attenuation}) {
    result.insert(result.end(), {color.x, color.y, color.z});
  }
  for (const shading::Vec4& color : checker.colors) {
    result.insert(result.end(), {color.x, color.y, color.z, color.w});
  }
  return result;
}

TEST(PhongPage, EveryExample_LoadsWithoutNotes) {
  EXPECT_EQ(page_examples().size(), 4u);
  for (const json& example : page_examples()) {
    const LoadedScene loaded = test::load_json(example);
    EXPECT_EQ(loaded.scene.world.instances.size(), 1u) << example;
    EXPECT_THAT(loaded.notes, IsEmpty()) << example;
    for (const ExtensionUse& use : loaded.extensions) {
      EXPECT_TRUE(example.dump().find(use.name + "\":") != std::string::npos) << use.name;
    }
  }
}

TEST(PhongPage, EveryPlaceAndProperty_IsThere) {
  const std::string page = test::read_text(tests::source_dir() / "docs/phong.md");
  for (const Place& place : k_places) {
    EXPECT_THAT(page_values(place), testing::Not(IsEmpty())) << place.schema;
    const json schema = test::load_schema(place.schema).json();
    for (const auto& property : schema.at("properties").items()) {
      EXPECT_NE(page.find("| `" + property.key() + "` |"), std::string::npos) << property.key();
    }
  }
}

TEST(PhongPage, ImageOfTheChecker_HasItsColours) {
  json example = page_examples().at(3);
  const shading::Scene drawn = test::load_json(example).scene;
  example["textures"][0].erase("extensions");
  const shading::Scene others = test::load_json(example).scene;
  ASSERT_EQ(others.images.size(), 1u);
  for (const shading::Vec2 uv : {shading::Vec2(0.25f, 0.25f), shading::Vec2(0.75f, 0.25f),
                                 shading::Vec2(0.25f, 1.75f), shading::Vec2(-0.25f, -0.25f)}) {
    const shading::Vec4 expected = drawn.textures.at(0).checker->value(uv);
    const shading::Vec4 shown = shading::sample_texture(others.textures.at(0), others.images[0],
                                                        shading::Encoding::srgb, uv);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(shown[i], expected[i], 0.005f);
  }
}

TEST(PhongSchema, Properties_AreThoseOfTheReader) {
  for (const Place& place : k_places) {
    const json schema = test::load_schema(place.schema).json();
    EXPECT_EQ(schema.at("$schema"), "https://json-schema.org/draft/2020-12/schema");
    EXPECT_EQ(schema.at("$id"), std::string(place.schema) + ".schema.json");
    std::string names;
    for (const auto& property : schema.at("properties").items()) {
      names += (names.empty() ? "" : ", ") + property.key();
    }
    // The note on a property that nobody knows lists those that the reader does.
    EXPECT_THAT(test::load_json(file_with(place, {{"QQQQQQ", 1}})).notes,
                testing::ElementsAre(testing::EndsWith("there are: " + names)));
  }
}

TEST(PhongSchema, Defaults_AreThoseOfTheReader) {
  int defaults = 0;
  for (const Place& place : k_places) {
    const json schema = test::load_schema(place.schema).json();
    const auto expected = fingerprint(test::load_json(file_with(place, json::object())).scene);
    for (const auto& [key, property] : schema.at("properties").items()) {
      if (!property.contains("default")) continue;
      const json with_default = {{key, property.at("default")}};
      EXPECT_EQ(fingerprint(test::load_json(file_with(place, with_default)).scene), expected)
          << key;
      ++defaults;
    }
  }
  EXPECT_EQ(defaults, 13);
}

TEST(PhongSchema, EveryExample_IsAccepted) {
  for (const Place& place : k_places) {
    for (const json& value : page_values(place)) {
      EXPECT_TRUE(test::load_schema(place.schema).accepts(value)) << value;
    }
  }
}

/// A value that the schema may accept or not, but for the rules that only its text gives.
json random_value(test::Random& random) {
  const std::vector<json> k_values = {nullptr,
                                      true,
                                      0,
                                      1,
                                      -1,
                                      0.5,
                                      -0.0,
                                      1.5,
                                      1e-300,
                                      1e20,
                                      3e38,
                                      1e300,
                                      "1",
                                      {1, 1},
                                      {0.5, 0, 1},
                                      {2, 3, 1e-9},
                                      {0, 0, 0, 1},
                                      {{0, 0, 0, 1}, {1, 1, 1}},
                                      json::array(),
                                      json::object()};
  return k_values[random.below(static_cast<std::uint32_t>(k_values.size()))];
}

TEST(PhongSchema, WhatItRefuses_TheReaderRefusesAndWhatLoadsIsFinite) {
  test::Random random(1975);
  int loaded = 0;
  int refused = 0;
  for (const Place& place : k_places) {
    const test::JsonSchema schema = test::load_schema(place.schema);
    for (int round = 0; round < 400; ++round) {
      json extension = json::object();
      for (const auto& property : schema.json().at("properties").items()) {
        if (random.below(4) == 0) extension[property.key()] = random_value(random);
      }
      SCOPED_TRACE(extension.dump());
      try {
        const shading::Scene scene = test::load_json(file_with(place, extension)).scene;
        EXPECT_TRUE(schema.accepts(extension));
        for (const double value : fingerprint(scene)) EXPECT_FALSE(std::isnan(value));
        EXPECT_TRUE(std::isfinite(scene.ambient.x + scene.materials[0].ior));
        ++loaded;
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::scene);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        ++refused;
      }
    }
  }
  EXPECT_GT(loaded, 400);
  EXPECT_GT(refused, 400);
}

}  // namespace
}  // namespace lume::io
