// SPDX-License-Identifier: Apache-2.0
// The scenes for comparing acceleration structures: sizes, bytes, and what makes each its
// character.
#include "assets/generator/characters.h"
#include "assets/generator/hash.h"
#include "assets/generator/noise.h"
#include "io/gltf/load_gltf.h"
#include "tests/cli/run_lume.h"
#include "tests/support/cases.h"
#include "tests/support/paths.h"
#include "tests/support/random.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace lume::generator {
namespace {

using geometry::Bounds;
using geometry::DVec3;
using geometry::Mesh;
using geometry::UVec3;
using geometry::Vec3;
using testing::HasSubstr;

/// A character in one of a few sizes; sanitizers see enough in the small ones.
class Sized : public testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {
 protected:
  [[nodiscard]] static const Character& character() {
    return characters()[std::get<0>(GetParam())];
  }
  [[nodiscard]] static std::size_t triangles() { return std::get<1>(GetParam()); }
};

std::string name_of(const testing::TestParamInfo<Sized::ParamType>& info) {
  const auto& [character, triangles] = info.param;
  return std::string(characters()[character].name) + "_" + std::to_string(triangles);
}

INSTANTIATE_TEST_SUITE_P(Generator, Sized,
                         testing::Combine(testing::Range<std::size_t>(0, 4),
                                          testing::Values(1000, 1300, 2000, 5000, 20000,
                                                          test::cases(300000))),
                         name_of);

double area(const Mesh& mesh, std::uint32_t triangle) {
  const auto [a, b, c] = mesh.corners(triangle);
  return 0.5 * length(cross(DVec3(b) - DVec3(a), DVec3(c) - DVec3(a)));
}

/// FNV-1a (Fowler, Noll and Vo) over the bytes.
template <class T>
std::uint64_t digest(const std::vector<T>& values) {
  std::uint64_t result = 0xcbf29ce484222325u;
  for (std::size_t i = 0; i < values.size() * sizeof(T); ++i) {
    unsigned char byte = 0;
    std::memcpy(&byte, reinterpret_cast<const unsigned char*>(values.data()) + i, 1);
    result = (result ^ byte) * 0x100000001b3u;
  }
  return result;
}

TEST_P(Sized, Count_WithinATenth) {
  const Mesh mesh = character().make(triangles());
  const auto asked = static_cast<double>(triangles());
  EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), asked, 0.1 * asked);
}

TEST_P(Sized, Arrays_HaveNoRoomToSpare) {
  const Mesh mesh = character().make(triangles());
  EXPECT_EQ(mesh.positions.capacity(), mesh.positions.size());
  EXPECT_EQ(mesh.triangles.capacity(), mesh.triangles.size());
}

TEST_P(Sized, Indices_InRangeAndAllPositionsUsed) {
  const Mesh mesh = character().make(triangles());
  std::vector<bool> used(mesh.positions.size(), false);
  for (const UVec3& triangle : mesh.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      ASSERT_LT(triangle[corner], mesh.positions.size());
      used[triangle[corner]] = true;
    }
  }
  // Sheets that end in a pole have the pole once more than their triangles need.
  const auto unused = std::count(used.begin(), used.end(), false);
  EXPECT_LE(unused, 8);
}

TEST_P(Sized, Positions_Finite) {
  const Mesh mesh = character().make(triangles());
  EXPECT_TRUE(std::all_of(mesh.positions.begin(), mesh.positions.end(), geometry::is_finite));
}

TEST_P(Sized, Triangles_HaveAreaButOneInAThousand) {
  const Mesh mesh = character().make(triangles());
  std::size_t flat = 0;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) flat += area(mesh, i) <= 0.0 ? 1 : 0;
  EXPECT_LE(flat, mesh.triangles.size() / 1000);
}

TEST_P(Sized, SameSize_SameBytes) {
  const Mesh first = character().make(triangles());
  const Mesh second = character().make(triangles());
  EXPECT_EQ(digest(first.positions), digest(second.positions));
  EXPECT_EQ(digest(first.triangles), digest(second.triangles));
}

/// Each edge by its ends, and how often it is walked from the lower to the higher one and back.
using Edges = std::unordered_map<std::uint64_t, std::array<int, 2>>;

Edges edges_of(const Mesh& mesh) {
  Edges edges;
  edges.reserve(2 * mesh.triangles.size());
  for (const UVec3& triangle : mesh.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint32_t a = triangle[corner];
      const std::uint32_t b = triangle[(corner + 1) % 3];
      const std::uint64_t key = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
      ++edges[key][a < b ? 0 : 1];
    }
  }
  return edges;
}

/// Six times the volume inside, by the divergence theorem; positive where fronts look outwards.
double sixfold_volume(const Mesh& mesh) {
  double sum = 0.0;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.corners(i);
    sum += dot(DVec3(a), cross(DVec3(b), DVec3(c)));
  }
  return sum;
}

TEST(Statue, EachEdge_OnceInEachDirection) {
  for (const std::size_t triangles : {1000u, 4321u, 60000u}) {
    const Mesh mesh = statue(triangles);
    const Edges edges = edges_of(mesh);
    const auto closed = [](const auto& edge) { return edge.second == std::array<int, 2>{1, 1}; };
    EXPECT_TRUE(std::all_of(edges.begin(), edges.end(), closed)) << triangles;
    // Euler's formula for two bodies without handles: V - E + F = 2 each.
    EXPECT_EQ(mesh.positions.size() + mesh.triangles.size(), edges.size() + 4);
  }
}

TEST(Statue, Volume_OfAFigureOnAPlinth) {
  // The plinth has about 0.9 x 0.9 x 0.55 m, the figure the size of a person in a wide robe.
  const double volume = sixfold_volume(statue(50000)) / 6.0;
  EXPECT_GT(volume, 0.55);
  EXPECT_LT(volume, 0.80);
}

TEST(Statue, Triangles_AreEven) {
  const Mesh mesh = statue(60000);
  std::vector<double> areas;
  areas.reserve(mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) areas.push_back(area(mesh, i));
  std::sort(areas.begin(), areas.end());
  EXPECT_LT(areas[areas.size() * 9 / 10], 10.0 * areas[areas.size() / 10]);
}

/// Bounds of the triangles that are smaller than a hand.
Bounds small_things(const Mesh& mesh, std::size_t& count) {
  Bounds bounds;
  count = 0;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto corners = mesh.corners(i);
    Bounds own;
    for (const Vec3& corner : corners) own.add(corner);
    if (own.radius() > 0.1f) continue;
    bounds.add(own);
    ++count;
  }
  return bounds;
}

TEST(Stadium, Teapot_HasTheTrianglesAndAThousandthOfTheSize) {
  for (const std::size_t triangles : {5000u, 100000u}) {
    const Mesh mesh = stadium(triangles);
    std::size_t small = 0;
    const Vec3 teapot = small_things(mesh, small).size();
    EXPECT_GT(static_cast<double>(small), 0.9 * static_cast<double>(mesh.triangles.size()));
    EXPECT_NEAR(teapot.x, 0.26f, 0.01f);
    EXPECT_GT(mesh.bounds().size().x, 1000.0f * teapot.x);
  }
}

TEST(Architecture, Triangles_LongAndThinBesideTiny) {
  const Mesh mesh = architecture(100000);
  std::size_t thin = 0;
  std::vector<double> areas;
  areas.reserve(mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.corners(i);
    const double longest = std::max({length(b - a), length(c - b), length(a - c)});
    areas.push_back(area(mesh, i));
    thin += longest * longest > 40.0 * areas.back() ? 1 : 0;  // 20 times as long as high
  }
  std::sort(areas.begin(), areas.end());
  EXPECT_GT(thin, mesh.triangles.size() / 50);
  EXPECT_GT(areas.back(), 1e5 * areas[areas.size() / 100]);
}

TEST(Architecture, Bounds_StayTheSame) {
  for (const std::size_t triangles : {30000u, 300000u}) {
    const Bounds bounds = architecture(triangles).bounds();
    EXPECT_NEAR(bounds.lower.x, -15.6f, 1e-4f);
    EXPECT_NEAR(bounds.lower.y, -0.5f, 1e-4f);
    EXPECT_NEAR(bounds.upper.y, 17.5f, 1e-4f);
    EXPECT_NEAR(bounds.upper.z, 9.6f, 1e-4f);
  }
}

TEST(Hair, Boxes_OverlapStrongly) {
  // Boxes of things that lie side by side fill the scene's box at most once, whatever they are.
  const Mesh mesh = hair(60000);
  constexpr std::size_t k_of_strand = std::size_t{2} * 3 * 12;  // three sides of 12 segments
  double boxes = 0.0;
  std::size_t strands = 0;
  for (std::size_t end = mesh.triangles.size(); end >= 2 * k_of_strand; end -= k_of_strand) {
    Bounds bounds;
    for (std::size_t i = end - k_of_strand; i < end; ++i) {
      for (const Vec3& corner : mesh.corners(static_cast<std::uint32_t>(i))) bounds.add(corner);
    }
    const DVec3 size(bounds.size());
    boxes += size.x * size.y * size.z;
    ++strands;
  }
  const DVec3 all(mesh.bounds().size());
  EXPECT_GT(strands, 500u);
  EXPECT_GT(boxes, 2.0 * all.x * all.y * all.z);
}

TEST(Noise, Lattice_ZeroAndContinuous) {
  test::Random random(5);
  for (int i = 0; i < test::cases(20000); ++i) {
    const Vec3 p = random.cube(50.0f);
    EXPECT_FLOAT_EQ(noise(glm::floor(p), 3), 0.0f);
    EXPECT_LE(std::abs(noise(p, 3)), 3.0f);
    // A slope of 1.5 times the fade's of 15/8 between gradients of up to sqrt 3.
    EXPECT_NEAR(noise(p, 3), noise(p + random.cube(1e-3f), 3), 3e-2f);
  }
}

TEST(Noise, Average_Zero) {
  test::Random random(6);
  double sum = 0.0;
  double squares = 0.0;
  const int count = test::cases(100000);
  for (int i = 0; i < count; ++i) {
    const double value = noise(random.cube(1000.0f), 9);
    sum += value;
    squares += value * value;
  }
  EXPECT_NEAR(sum / count, 0.0, 5.0 * std::sqrt(squares) / count);
  EXPECT_GT(squares / count, 0.01);
}

TEST(Hash, Units_AreUniform) {
  // Sixteen classes of 4096 expected each: the standard deviation of one is about 62.
  std::array<int, 16> classes{};
  for (std::uint64_t i = 0; i < 65536; ++i) {
    const float value = random_unit(i, 7);
    ASSERT_GE(value, 0.0f);
    ASSERT_LT(value, 1.0f);
    ++classes[static_cast<std::size_t>(16.0f * value)];
  }
  for (const int count : classes) EXPECT_NEAR(count, 4096, 5 * 62);
}

TEST(GenerateScene, File_LoadsWithTheMesh) {
  for (const Character& character : characters()) {
    const tests::TemporaryFolder folder;
    const std::string name(character.name);
    const cli::Outcome outcome =
        cli::run_lume(folder, {name, "--triangles", "2.5k", "-o", "scene.glb"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const io::LoadedScene loaded = io::load_gltf(folder / "scene.glb");
    const Mesh expected = character.make(2500);
    const auto& objects = loaded.scene.world.objects;
    ASSERT_EQ(objects.size(), 1u);
    const auto& mesh = std::get<Mesh>(objects[0].geometries.at(0).surface);
    EXPECT_EQ(mesh.positions, expected.positions);
    EXPECT_EQ(mesh.triangles, expected.triangles);
    ASSERT_EQ(loaded.scene.cameras.size(), 1u);
    const geometry::Camera& camera = loaded.scene.cameras[0];
    EXPECT_LT(length(camera.position - character.eye), 1e-5f);
    const Vec3 forward = normalize(character.target - character.eye);
    EXPECT_LT(length(camera.backward + forward), 1e-5f);
    EXPECT_EQ(loaded.scene.lights.size(), 1u);
    EXPECT_TRUE(loaded.notes.empty()) << loaded.notes.front();
  }
}

TEST(GenerateScene, Mistakes_OneLineAndUsage) {
  const tests::TemporaryFolder folder;
  const std::vector<std::pair<std::vector<std::string>, std::string>> mistakes = {
      {{"statu", "-o", "a.glb"}, "did you mean 'statue'"},
      {{"-o", "a.glb"}, "no character given"},
      {{"hair"}, "no file to write"},
      {{"hair", "-o", "a.gltf"}, "ends in .glb"},
      {{"hair", "--triangles", "999", "-o", "a.glb"}, "expected 1000 to 10M"},
      {{"hair", "--triangles", "11M", "-o", "a.glb"}, "expected 1000 to 10M"},
      {{"hair", "--triangles", "2x", "-o", "a.glb"}, "got '2x'"},
      {{"hair", "--triangles", "nan", "-o", "a.glb"}, "got 'nan'"},
      {{"hair", "--wrong", "-o", "a.glb"}, "--wrong"},
  };
  for (const auto& [arguments, message] : mistakes) {
    const cli::Outcome outcome = cli::run_lume(folder, arguments);
    EXPECT_EQ(outcome.exit_code, 2) << message;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  const cli::Outcome unwritable = cli::run_lume(folder, {"hair", "-o", "no/such/folder/a.glb"});
  EXPECT_EQ(unwritable.exit_code, 4) << unwritable.err;
}

}  // namespace
}  // namespace lume::generator
