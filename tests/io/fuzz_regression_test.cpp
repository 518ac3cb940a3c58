// SPDX-License-Identifier: Apache-2.0
// What the fuzzer starts from loads; what it has found before never breaks the loader again.
#include "io/check/check_scene.h"
#include "io/error.h"
#include "io/gltf/load_gltf.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace lume::io {
namespace {

namespace fs = std::filesystem;

const fs::path k_folder = fs::path(LUME_SOURCE_DIR) / "tests" / "fuzz";

TEST(FuzzRegression, Corpus_LoadsAndCanBeChecked) {
  int files = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(k_folder / "corpus")) {
    SCOPED_TRACE(entry.path());
    EXPECT_FALSE(load_gltf(entry.path()).scene.world.instances.empty());
    EXPECT_NO_THROW(static_cast<void>(check::check_scene(entry.path())));
    ++files;
  }
  EXPECT_GE(files, 6);
}

TEST(FuzzRegression, OldFindings_LoadOrEndInAnError) {
  if (!fs::exists(k_folder / "regressions")) GTEST_SKIP() << "nothing was ever found";
  for (const fs::directory_entry& entry : fs::directory_iterator(k_folder / "regressions")) {
    SCOPED_TRACE(entry.path());
    try {
      static_cast<void>(load_gltf(entry.path()));
      static_cast<void>(check::check_scene(entry.path()));
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace lume::io
