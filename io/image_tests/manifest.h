// SPDX-License-Identifier: Apache-2.0
// The list of image tests that `lume test` runs: a TOML file, in which defaults, globs and
// overrides keep many cases short. docs/image_tests.md describes the format.
#pragma once

#include "io/compare/comparison.h"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace lume::io {

/// How an image is held against its reference.
enum class Tier {
  exact,        ///< the decoded pixels are equal, all of them
  statistical,  ///< images of other seeds have the same expectation
  perceptual,   ///< metrics keep their limits
};

[[nodiscard]] const char* tier_name(Tier tier);

/// One image and what it has to look like. Paths are absolute, or as the manifest's own path.
struct TestCase {
  std::string name;  ///< of no other case; good as the name of a folder
  int line = 0;      ///< of its [[case]] in the manifest

  // Where the image comes from: a scene, a command (which leaves it in `image` or where {output}
  // says), or a file that is there.
  std::filesystem::path scene;
  std::vector<std::string> command;  ///< {output}, {seed} and {lume} are still to be replaced
  std::filesystem::path image;
  std::vector<std::string> render;  ///< options of `lume render`; later ones win

  std::filesystem::path reference;
  Tier tier = Tier::exact;
  CompareSettings compare;     ///< of the perceptual tier
  int seeds = 8;               ///< statistical: images on each side
  double significance = 0.01;  ///< statistical: how often equal expectations may fail
  double timeout = 300.0;      ///< seconds a command may take
  std::string skip;            ///< why it is not run; empty: it is
};

struct Manifest {
  std::filesystem::path file;
  std::filesystem::path folder;  ///< where relative paths start, and where commands run
  std::vector<TestCase> cases;   ///< in the manifest's order; files of a glob by name
};

/// What is wrong in a manifest: "tests.toml:12: ..." in one line.
class ManifestError : public std::runtime_error {
 public:
  ManifestError(const std::filesystem::path& file, int line, const std::string& message)
      : std::runtime_error(file.string() + ":" + std::to_string(line) + ": " + message) {}
};

/// Throws ManifestError for what it says, Error(input_output) if it cannot be read.
[[nodiscard]] Manifest read_manifest(const std::filesystem::path& file);

}  // namespace lume::io
