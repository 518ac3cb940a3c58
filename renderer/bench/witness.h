// SPDX-License-Identifier: Apache-2.0
// Two structures behind one face, to find the first question that they answer differently.
#pragma once

#include "geometry/accelerators/accelerator.h"

#include <memory>
#include <optional>

namespace lume::renderer {

/// A question that two structures answer differently.
struct Disagreement {
  geometry::Ray ray;
  bool any_hit = false;  ///< it was whether there is anything; else what comes first
  /// What comes first by each of them, whichever the question was.
  std::optional<geometry::Hit> hits[2];
  bool occluded[2] = {false, false};  ///< what any_hit says
};

/// Answers as the first structure does, and notes where the second would have said something else.
/// For one thread at a time. Each structure is asked for what it says of the whole ray when a
/// difference is noted.
class Witness final : public geometry::Accelerator {
 public:
  Witness(std::unique_ptr<geometry::Accelerator> first,
          std::unique_ptr<geometry::Accelerator> second);

  [[nodiscard]] std::optional<geometry::Hit> closest_hit(const geometry::Ray& ray) const override;
  [[nodiscard]] bool any_hit(const geometry::Ray& ray) const override;
  void prepare_view(const geometry::Camera& camera, int width, int height) override;
  [[nodiscard]] geometry::AcceleratorStats stats() const override;

  /// Since the Witness was made.
  [[nodiscard]] const std::optional<Disagreement>& first_disagreement() const { return found_; }

 private:
  void note(const geometry::Ray& ray, bool any_hit) const;

  std::unique_ptr<geometry::Accelerator> first_;
  std::unique_ptr<geometry::Accelerator> second_;
  mutable std::optional<Disagreement> found_;
};

/// What both say of a ray.
[[nodiscard]] Disagreement ask_both(const geometry::Accelerator& first,
                                    const geometry::Accelerator& second, const geometry::Ray& ray,
                                    bool any_hit);

}  // namespace lume::renderer
