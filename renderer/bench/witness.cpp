// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/witness.h"

#include <utility>

namespace lume::renderer {

using geometry::Accelerator;
using geometry::Hit;
using geometry::Ray;

Disagreement ask_both(const Accelerator& first, const Accelerator& second, const Ray& ray,
                      bool any_hit) {
  Disagreement result;
  result.ray = ray;
  result.any_hit = any_hit;
  const Accelerator* const both[2] = {&first, &second};
  for (int i = 0; i < 2; ++i) {
    result.hits[i] = both[i]->closest_hit(ray);
    result.occluded[i] = both[i]->any_hit(ray);
  }
  return result;
}

Witness::Witness(std::unique_ptr<Accelerator> first, std::unique_ptr<Accelerator> second)
    : first_(std::move(first)), second_(std::move(second)) {}

std::optional<Hit> Witness::closest_hit(const Ray& ray) const {
  const auto hit = first_->closest_hit(ray);
  if (!found_ && second_->closest_hit(ray) != hit) note(ray, false);
  return hit;
}

bool Witness::any_hit(const Ray& ray) const {
  const bool occluded = first_->any_hit(ray);
  if (!found_ && second_->any_hit(ray) != occluded) note(ray, true);
  return occluded;
}

void Witness::prepare_view(const geometry::Camera& camera, int width, int height) {
  first_->prepare_view(camera, width, height);
  second_->prepare_view(camera, width, height);
}

geometry::AcceleratorStats Witness::stats() const { return first_->stats(); }

void Witness::note(const Ray& ray, bool any_hit) const {
  found_ = ask_both(*first_, *second_, ray, any_hit);
}

}  // namespace lume::renderer
