// SPDX-License-Identifier: Apache-2.0
// Equality of structures by the pictures they give. A hit is an identity and everything else
// follows from it, so structures that agree give one picture to the last bit; and where two
// pictures differ there is a first ray on which their structures do.
#pragma once

#include "renderer/bench/bench.h"
#include "renderer/bench/witness.h"
#include "renderer/render.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lume::renderer {

/// What is rendered through every structure.
struct ProofSettings {
  RenderSettings render;
  std::string integrator = "whitted";
  IntegratorSettings method;
  std::function<void(double)> on_progress;
};

/// Where the picture of a structure first differs from that of the first.
struct Mismatch {
  int x = 0;  ///< pixel, in scan order
  int y = 0;
  std::size_t pixels = 0;  ///< that differ
  /// The first ray behind that pixel which is answered differently. Nothing if none is when the
  /// pixel is rendered again: then a structure does not always give the same answer.
  std::optional<Disagreement> ray;
};

struct ProofOfOne {
  std::string name;
  Film film;
  std::optional<Mismatch> mismatch;  ///< with the first candidate
};

/// Renders the scene through each candidate, which must be exact (AcceleratorOptions{}).
[[nodiscard]] std::vector<ProofOfOne> prove(const shading::Scene& scene,
                                            const geometry::Camera& camera,
                                            std::span<const Candidate> candidates,
                                            const ProofSettings& settings);

}  // namespace lume::renderer
