// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/build_time.h"

#include "geometry/parallel.h"
#include "renderer/bench/statistics.h"

#include <chrono>
#include <vector>

namespace lume::renderer {
namespace {

constexpr double k_cheap_seconds = 2.0;
constexpr int k_cheap_builds = 5;
constexpr int k_dear_builds = 1;

class Builder {
 public:
  Builder(const AcceleratorFactory& make_accelerator, const geometry::World& world,
          const geometry::HoleTest* holes, const std::function<void()>& on_built)
      : make_accelerator_(make_accelerator), world_(world), holes_(holes), on_built_(on_built) {}

  /// Seconds. The structure of before is gone first, so that memory is there for one.
  double build() {
    accelerator_.reset();
    const auto start = std::chrono::steady_clock::now();
    accelerator_ = make_accelerator_(world_, holes_);
    const auto end = std::chrono::steady_clock::now();
    if (on_built_) on_built_();
    return std::chrono::duration<double>(end - start).count();
  }
  double median_of(int count) {
    std::vector<double> seconds;
    seconds.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) seconds.push_back(build());
    return median(std::move(seconds));
  }
  std::unique_ptr<geometry::Accelerator> take() { return std::move(accelerator_); }

 private:
  const AcceleratorFactory& make_accelerator_;
  const geometry::World& world_;
  const geometry::HoleTest* holes_;
  const std::function<void()>& on_built_;
  std::unique_ptr<geometry::Accelerator> accelerator_;
};

}  // namespace

Build measure_build(const AcceleratorFactory& make_accelerator, const geometry::World& world,
                    const geometry::HoleTest* holes, const std::function<void()>& on_built) {
  Build result;
  Builder builder(make_accelerator, world, holes, on_built);
  const double first = builder.build();
  result.builds = first < k_cheap_seconds ? k_cheap_builds : k_dear_builds;
  {
    const geometry::ThreadLimit one(1);
    result.one_thread_seconds = builder.median_of(result.builds);
  }
  const geometry::ThreadLimit all(0);
  result.threads = all.threads();
  result.all_threads_seconds =
      result.threads == 1 ? result.one_thread_seconds : builder.median_of(result.builds);
  result.accelerator = builder.take();
  return result;
}

}  // namespace lume::renderer
