// SPDX-License-Identifier: Apache-2.0
// Shapes changed at random: each file loads, or ends in one line of an Error.
#include "io/error.h"
#include "tests/io/gltf_shape_file.h"
#include "tests/support/random.h"
#include "tests/support/shape_examples.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::io {
namespace {

using nlohmann::json;

json random_value(test::Random& random) {
  const std::vector<json> k_values = {nullptr,
                                      true,
                                      false,
                                      0,
                                      1,
                                      -1,
                                      0.5,
                                      1e-15,
                                      1e15,
                                      -1e15,
                                      1e-300,
                                      1e300,
                                      1e-9,
                                      2,
                                      "x*y-z",
                                      "1/x",
                                      "sqrt(x)-1/0*y",
                                      "ellipsoid",
                                      "cone",
                                      "box",
                                      "plane",
                                      "",
                                      "x^x^x",
                                      "tan(x*9e9)",
                                      json::array(),
                                      json::object(),
                                      -0.0};
  return k_values[random.below(static_cast<std::uint32_t>(k_values.size()))];
}

/// A place in the JSON, chosen at random.
json::json_pointer random_place(const json& value, test::Random& random) {
  const json flat = value.flatten();
  auto chosen = flat.items().begin();
  for (std::uint32_t skip = random.below(static_cast<std::uint32_t>(flat.size())); skip > 0;
       --skip) {
    ++chosen;
  }
  json::json_pointer place(chosen.key());
  while (!place.empty() && random.below(4) == 0) place = place.parent_pointer();
  return place;
}

void change(json& shape, test::Random& random) {
  const json::json_pointer place = random_place(shape, random);
  if (place.empty()) return;
  json& value = shape[place];
  switch (random.below(4)) {
    case 0:
      value = random_value(random);
      break;
    case 1:
      if (value.is_number()) value = value.get<double>() * std::pow(10.0, random.uniform(-20, 20));
      break;
    case 2:
      if (value.is_number()) value = value.get<double>() + random.uniform(-2, 2);
      break;
    default:
      if (value.is_array() && !value.empty()) {
        value.push_back(value.at(random.below(static_cast<std::uint32_t>(value.size()))));
      } else if (value.is_string()) {
        std::string text = value.get<std::string>();
        text.insert(random.below(static_cast<std::uint32_t>(text.size() + 1)), 1,
                    "xyz()+-*/^0.e,"[random.below(14)]);
        value = text;
      }
  }
}

/// What was loaded can be asked: no crash, and no crossing that is not a number.
void use(const LoadedScene& loaded, test::Random& random) {
  for (const geometry::Object& object : loaded.scene.world.objects) {
    for (const geometry::Geometry& geometry : object.geometries) {
      const geometry::Shape& shape = *geometry.shape();
      for (int i = 0; i < 4; ++i) {
        const geometry::ObjectRay ray{geometry::DVec3(random.cube(3.0f)),
                                      geometry::DVec3(random.direction())};
        if (const auto crossing = geometry::intersect(shape, ray)) {
          EXPECT_TRUE(std::isfinite(crossing->t));
          static_cast<void>(geometry::shape_point(shape, ray, *crossing));
        }
      }
    }
  }
}

TEST(GltfShapeFuzz, ChangedExamples_LoadOrEndInAnError) {
  constexpr int k_rounds = 120;  // of each shape of the page
  test::Random random(1980);
  int loaded = 0;
  int refused = 0;
  for (const json& example : test::example_shapes()) {
    for (int round = 0; round < k_rounds; ++round) {
      json shape = example;
      for (std::uint32_t i = 0; i <= random.below(4); ++i) change(shape, random);
      SCOPED_TRACE(shape.dump());
      try {
        use(test::load_json(test::shape_file(shape)), random);
        ++loaded;
      } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        EXPECT_EQ(error.kind(), ErrorKind::scene);
        ++refused;
      }
    }
  }
  EXPECT_GT(loaded, 500);
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace lume::io
