// SPDX-License-Identifier: Apache-2.0
// Models that $LUME_TEST_DATA has in several encodings must be the same scene, within half a step
// of the quantization that each file says it has.
#include "geometry/parallel.h"
#include "io/error.h"
#include "io/gltf/load_gltf.h"
#include "tests/io/encoding_tolerance.h"
#include "tests/support/cases.h"
#include "tests/support/gltf_file.h"
#include "tests/support/memory_limit.h"
#include "tests/support/paths.h"
#include "tests/support/random.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lume::io {
namespace {

namespace fs = std::filesystem;
using geometry::DVec3;
using test::draco_tolerance;
using test::integer_tolerance;
using test::read_text;
using test::Tolerance;

struct Corner {
  DVec3 position{0.0};  ///< in the world
  DVec3 normal{0.0};
  glm::dvec2 uv{0.0};  ///< where the base colour texture is read
};
using Triangle = std::array<Corner, 3>;

std::vector<Triangle> triangles_of(const LoadedScene& loaded) {
  std::vector<Triangle> result;
  const shading::Scene& scene = loaded.scene;
  for (const geometry::Instance& instance : scene.world.instances) {
    for (const geometry::Geometry& geometry : scene.world.objects[instance.object].geometries) {
      const geometry::Mesh& mesh = *geometry.mesh();
      const auto& transform = scene.materials[geometry.material].base_color_texture.transform;
      for (const geometry::UVec3& indices : mesh.triangles) {
        Triangle& triangle = result.emplace_back();
        for (int c = 0; c < 3; ++c) {
          Corner& corner = triangle[static_cast<std::size_t>(c)];
          corner.position =
              instance.transform.point_to_world(DVec3(mesh.positions[indices[c]])) + scene.origin;
          corner.normal =
              normalize(instance.transform.normal_to_world(DVec3(mesh.normals[indices[c]])));
          if (!mesh.texcoords.empty()) {
            corner.uv = glm::dvec2(transform.apply(mesh.texcoords[0][indices[c]]));
          }
        }
      }
    }
  }
  return result;
}

double distance_of(const Triangle& a, const Triangle& b, std::size_t turn,
                   double Tolerance::*which) {
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    const Corner& other = b[(c + turn) % 3];
    const double d = which == &Tolerance::position ? length(a[c].position - other.position)
                     : which == &Tolerance::normal ? length(a[c].normal - other.normal)
                                                   : length(a[c].uv - other.uv);
    largest = std::max(largest, d);
  }
  return largest;
}

/// Whether `b` has a triangle that is `a` within the tolerance.
bool has_match(const Triangle& a, const std::vector<Triangle>& candidates,
               const Tolerance& within) {
  return std::any_of(candidates.begin(), candidates.end(), [&](const Triangle& b) {
    const DVec3 centers = a[0].position + a[1].position + a[2].position - b[0].position -
                          b[1].position - b[2].position;
    if (length(centers) > 3.0 * within.position) return false;
    for (std::size_t turn = 0; turn < 3; ++turn) {
      if (distance_of(a, b, turn, &Tolerance::position) <= within.position &&
          distance_of(a, b, turn, &Tolerance::normal) <= within.normal &&
          distance_of(a, b, turn, &Tolerance::uv) <= within.uv) {
        return true;
      }
    }
    return false;
  });
}

void expect_equal(const fs::path& a, const fs::path& b, const Tolerance& within) {
  const std::vector<Triangle> first = triangles_of(load_gltf(a, {.decode_images = false}));
  const std::vector<Triangle> second = triangles_of(load_gltf(b, {.decode_images = false}));
  ASSERT_FALSE(first.empty());
  ASSERT_EQ(first.size(), second.size());
  std::size_t lost = 0;
  for (const Triangle& triangle : first) lost += has_match(triangle, second, within) ? 0 : 1;
  for (const Triangle& triangle : second) lost += has_match(triangle, first, within) ? 0 : 1;
  EXPECT_EQ(lost, 0u) << "of " << 2 * first.size() << " triangles, within " << within.position
                      << ", " << within.normal << " and " << within.uv;
}

/// Room for what floats round.
Tolerance widened(Tolerance tolerance) {
  tolerance.position += 1e-5;
  tolerance.normal += 1e-5;
  tolerance.uv += 1e-6;
  return tolerance;
}

class GltfEncodings : public testing::Test {
 protected:
  void SetUp() override {
    const auto data = tests::test_data();
    if (!data) GTEST_SKIP() << "LUME_TEST_DATA is not set";
    assets_ = *data / "gltf/assets";
    if (!fs::exists(assets_)) GTEST_SKIP() << assets_ << " is not there";
  }
  fs::path assets_;
};

TEST_F(GltfEncodings, Draco_IsWithinItsSteps) {
  for (const auto& [plain, compressed] :
       {std::pair{"Box/glTF-Embedded/Box.gltf", "Box/glTF-Draco/Box.gltf"},
        {"Duck/glTF/Duck.gltf", "Duck/glTF-Draco/Duck.gltf"},
        {"MorphPrimitivesTest/glTF-Binary/MorphPrimitivesTest.glb",
         "MorphPrimitivesTest/glTF-Draco/MorphPrimitivesTest.gltf"}}) {
    SCOPED_TRACE(compressed);
    expect_equal(assets_ / plain, assets_ / compressed,
                 widened(draco_tolerance(assets_ / compressed)));
  }
}

TEST_F(GltfEncodings, Quantized_IsWithinItsSteps) {
  for (const auto& [plain, quantized] :
       {std::pair{"Duck/glTF/Duck.gltf", "Duck/glTF-Quantized/Duck.gltf"},
        {"AnimatedMorphCube/glTF-Binary/AnimatedMorphCube.glb",
         "AnimatedMorphCube/glTF-Quantized/AnimatedMorphCube.gltf"}}) {
    SCOPED_TRACE(quantized);
    expect_equal(assets_ / plain, assets_ / quantized,
                 widened(integer_tolerance(assets_ / quantized)));
  }
}

/// From octahedral coordinates, as bytes, to the direction (KHR_meshopt_compression, appendix B).
void decode_octahedral(char* bytes) {
  DVec3 v(static_cast<signed char>(bytes[0]), static_cast<signed char>(bytes[1]), 0.0);
  v /= static_cast<double>(bytes[2]);
  v.z = 1.0 - std::abs(v.x) - std::abs(v.y);
  const double fold = std::max(-v.z, 0.0);
  v.x += v.x < 0.0 ? fold : -fold;
  v.y += v.y < 0.0 ? fold : -fold;
  v = round(normalize(v) * 127.0);
  for (int c = 0; c < 3; ++c) bytes[c] = static_cast<char>(v[c]);
}

/// The model's fallback without the extension. Its normals, the second view, are those before the
/// filter, as the exporter left them.
void write_plain(const fs::path& model, const fs::path& folder) {
  nlohmann::json json = nlohmann::json::parse(read_text(model / "meshopt-fallback.gltf"));
  const std::size_t offset = json["bufferViews"][1]["byteOffset"];
  const std::size_t size = json["bufferViews"][1]["byteLength"];
  std::string bytes = read_text(model / "meshopt-fallback.fallback.bin");
  for (std::size_t at = offset; at < offset + size; at += 4) decode_octahedral(&bytes[at]);
  for (auto& view : json["bufferViews"]) view.erase("extensions");
  json["extensionsUsed"] = {"KHR_mesh_quantization"};
  json.erase("extensionsRequired");
  json["buffers"] = {{{"uri", "plain.bin"}, {"byteLength", 0}}, json["buffers"][1]};
  json["buffers"][1]["uri"] = "plain.bin";
  test::write_bytes(folder / "plain.bin", bytes);
  test::write_bytes(folder / "plain.gltf", json.dump());
}

/// Both forms under both names. Positions are exact; the library's filter of normals may differ by
/// a byte's last digit.
TEST_F(GltfEncodings, Meshopt_IsItsFallback) {
  const tests::TemporaryFolder folder;
  Tolerance tolerance;
  tolerance.normal = 2.0 / 127.0;
  for (const std::string name : {"EXT", "KHR"}) {
    const fs::path model = assets_ / ("MeshoptBox-" + name);
    write_plain(model / "meshopt-fallback", folder.path());
    for (const std::string form : {"meshopt-fallback", "meshopt-no-fallback"}) {
      SCOPED_TRACE(name + " " + form);
      expect_equal(folder / "plain.gltf", model / form / (form + ".gltf"), widened(tolerance));
    }
  }
}

/// Bits are flipped in the compressed data of real models, 2000 times.
TEST_F(GltfEncodings, DamagedModels_LoadOrEndInAnError) {
  const geometry::ThreadLimit one_thread(1);
  const tests::TemporaryFolder folder;
  test::Random random(1);
  int refused = 0;
  for (const auto& [file, data] :
       {std::pair{"Box/glTF-Draco/Box.gltf", "Box.bin"},
        {"MorphPrimitivesTest/glTF-Draco/MorphPrimitivesTest.gltf", "MorphPrimitivesTest.bin"},
        {"MeshoptBox-EXT/meshopt-no-fallback/meshopt-no-fallback.gltf",
         "meshopt-no-fallback.bin"}}) {
    const fs::path path = assets_ / file;
    nlohmann::json json = nlohmann::json::parse(read_text(path));
    json.erase("images");  // they are beside the model, not in the folder
    json.erase("textures");
    json.erase("materials");
    for (auto& mesh : json["meshes"]) {
      for (auto& primitive : mesh["primitives"]) primitive.erase("material");
    }
    test::write_bytes(folder / "model.gltf", json.dump());
    const std::string good = read_text(path.parent_path() / data);
    test::write_bytes(folder / data, good);
    static_cast<void>(load_gltf(folder / "model.gltf"));
    const test::MemoryLimit limit(std::size_t{1} << 30);
    for (int i = 0; i < test::cases(700); ++i) {
      std::string bad = good;
      char& byte = bad[random.below(static_cast<std::uint32_t>(bad.size()))];
      byte = static_cast<char>(byte ^ (1 << random.below(8)));
      fs::remove(folder / data);  // some file systems wait for the disk when a file is overwritten
      test::write_bytes(folder / data, bad);
      try {
        static_cast<void>(load_gltf(folder / "model.gltf"));
      } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("bad_alloc")));
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, test::cases(200));
}

}  // namespace
}  // namespace lume::io
