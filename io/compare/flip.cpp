// SPDX-License-Identifier: Apache-2.0
#include "io/compare/flip.h"

#include "io/compare/flip_tiles.h"

namespace lume::io {

std::vector<float> flip(const RgbImage& reference, const RgbImage& test,
                        const FlipOptions& options) {
  check_flip(reference, test, options);
  return flip_map(reference, test, {}, make_flip_kernels(options.pixels_per_degree));
}

}  // namespace lume::io
