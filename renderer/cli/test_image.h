// SPDX-License-Identifier: Apache-2.0
// The image of a case of `lume test`, however it comes about.
#pragma once

#include "renderer/cli/test_plan.h"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace lume::cli {

/// Why a case has no image. One line.
class ImageProblem : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Seeds of references are this much higher than those of the images that are held against them:
/// the statistical test wants them to be independent.
constexpr std::uint64_t k_reference_seeds = std::uint64_t{1} << 32u;

/// Makes the case's image in its folder and returns where it is: a picture, or in the statistical
/// tier a stack of pictures with seeds from `first_seed` on. `name` is its file's, without the
/// extension. What a command says is in `log.txt` beside it. Throws ImageProblem, io::Error and
/// UsageError.
[[nodiscard]] std::filesystem::path make_image(const PlannedCase& planned, const std::string& name,
                                               std::uint64_t first_seed,
                                               const std::atomic<bool>& cancel);

}  // namespace lume::cli
