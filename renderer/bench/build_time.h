// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderer/prepared_scene.h"

#include <functional>
#include <memory>

namespace lume::renderer {

/// A structure, and what it took to build it.
struct Build {
  std::unique_ptr<geometry::Accelerator> accelerator;
  double one_thread_seconds = 0.0;  ///< medians
  double all_threads_seconds = 0.0;
  unsigned threads = 1;  ///< what "all" are
  int builds = 1;        ///< of which each is the median
};

/// Builds the structure several times, on one thread and on all. The first build of a process pays
/// for its warm-up (pages, threads, Embree's own tables) and does not count; one that takes long is
/// built fewer times. No ThreadLimit may be alive. `on_built` is called after each build.
[[nodiscard]] Build measure_build(const AcceleratorFactory& make_accelerator,
                                  const geometry::World& world, const geometry::HoleTest* holes,
                                  const std::function<void()>& on_built = {});

}  // namespace lume::renderer
