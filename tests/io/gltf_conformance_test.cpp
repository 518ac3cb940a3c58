// SPDX-License-Identifier: Apache-2.0
// Real files of others ($LUME_TEST_DATA): what is well formed loads, what is not ends in an Error.
#include "io/error.h"
#include "io/gltf/load_gltf.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

namespace lume::io {
namespace {

namespace fs = std::filesystem;

/// Files below `folder` that are refused, each with a part of the reason.
using Refusals = std::map<std::string, std::string>;

std::vector<fs::path> models_below(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path extension = entry.path().extension();
    if (entry.is_regular_file() && (extension == ".gltf" || extension == ".glb")) {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// All models load but those listed, which are refused for the reason given. A listed model that
/// loads, or that is not there, is a failure: the list is to stay true.
void expect_loads_except(const fs::path& folder, Refusals refusals) {
  const std::vector<fs::path> models = models_below(folder);
  EXPECT_FALSE(models.empty());
  for (const fs::path& model : models) {
    const std::string name = model.lexically_relative(folder).string();
    const auto refusal = refusals.find(name);
    try {
      static_cast<void>(load_gltf(model));
      EXPECT_TRUE(refusal == refusals.end()) << name << " loads now: take it off the list";
    } catch (const Error& error) {
      if (refusal == refusals.end()) {
        ADD_FAILURE() << error.what();
      } else {
        EXPECT_EQ(error.kind(), ErrorKind::scene);
        EXPECT_NE(std::string(error.what()).find(refusal->second), std::string::npos)
            << error.what();
      }
    }
    if (refusal != refusals.end()) refusals.erase(refusal);
  }
  for (const auto& [name, reason] : refusals) ADD_FAILURE() << name << " is not there";
}

class GltfConformance : public testing::Test {
 protected:
  void SetUp() override {
    const auto data = tests::test_data();
    if (!data) GTEST_SKIP() << "LUME_TEST_DATA is not set";
    folder_ = *data / "gltf";
    if (!fs::exists(folder_)) GTEST_SKIP() << folder_ << " is not there";
  }
  fs::path folder_;
};

TEST_F(GltfConformance, SampleAssets_Load) {
  expect_loads_except(folder_ / "assets",
                      {{"AnisotropyBarnLamp/glTF-KTX-BasisU/AnisotropyBarnLamp.gltf", "KTX2"}});
}

TEST_F(GltfConformance, GeneratedPositives_Load) {
  Refusals refusals = {
      {"Compatibility/Compatibility_04.gltf", "/asset/minVersion"},  // asks for glTF 2.1
      {"Compatibility/Compatibility_05.gltf", "FAKE_materials_quantumRendering"}};
  // Their textures are not part of the data: these test how a missing image is reported.
  const auto without_textures = [&](const std::string& group, int count) {
    for (int i = 0; i < count; ++i) {
      std::string path = group;
      path.append("/").append(group).append(i < 10 ? "_0" : "_").append(std::to_string(i));
      refusals[path.append(".gltf")] = "/images/0/uri: names";
    }
  };
  without_textures("Node_Attribute", 9);
  without_textures("Node_NegativeScale", 13);
  expect_loads_except(folder_ / "generator/Positive", refusals);
}

TEST_F(GltfConformance, GeneratedNegatives_AreRefusedOrEmpty) {
  for (const fs::path& model : models_below(folder_ / "generator/Negative/Mesh_NoPosition")) {
    const LoadedScene loaded = load_gltf(model);
    EXPECT_TRUE(loaded.scene.world.instances.empty());
    EXPECT_FALSE(loaded.notes.empty());
  }
  int refused = 0;
  for (const fs::path& model : models_below(folder_ / "generator/Negative/Mesh_PrimitiveRestart")) {
    try {
      const LoadedScene loaded = load_gltf(model);
      EXPECT_FALSE(loaded.notes.empty()) << model;  // points and lines, which are not drawn
      EXPECT_TRUE(loaded.scene.world.instances.empty()) << model;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("/indices: index"), std::string::npos)
          << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

TEST_F(GltfConformance, ValidatorInputs_LoadOrEndInAnError) {
  std::size_t loaded = 0;
  std::size_t refused = 0;
  for (const fs::path& model : models_below(folder_ / "validator")) {
    try {
      static_cast<void>(load_gltf(model));
      ++loaded;
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(loaded, 200u);
  EXPECT_GT(refused, 100u);
}

}  // namespace
}  // namespace lume::io
