// SPDX-License-Identifier: Apache-2.0
#include "io/compare/pixel_hash.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <memory>
#include <new>
#include <numeric>
#include <string_view>

namespace lume::io {
namespace {

class Hasher {
 public:
  Hasher() {
    if (!state_) throw std::bad_alloc();
    XXH3_128bits_reset(state_.get());
  }
  void add(std::string_view text) { XXH3_128bits_update(state_.get(), text.data(), text.size()); }
  void add(const std::vector<float>& values) {
    XXH3_128bits_update(state_.get(), values.data(), values.size() * sizeof(float));
  }
  [[nodiscard]] std::string hex() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
  }

 private:
  std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state_{XXH3_createState(),
                                                                  &XXH3_freeState};
};

void add(Hasher& hasher, const ChannelImage& image) {
  const shading::PixelRegion& region = image.region;
  hasher.add(fmt::format("{}x{} {}x{}{:+}{:+}\n", image.full_width, image.full_height, region.width,
                         region.height, region.x, region.y));
  std::vector<std::size_t> order(image.channels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return image.channels[a] < image.channels[b]; });
  for (const std::size_t i : order) {
    hasher.add(image.channels[i] + "\n");
    hasher.add(image.planes[i]);
  }
}

}  // namespace

std::string pixel_hash(const ImageFile& file) {
  Hasher hasher;
  for (const ChannelImage& image : file.images) add(hasher, image);
  return hasher.hex();
}

}  // namespace lume::io
