// SPDX-License-Identifier: Apache-2.0
#include "shading/image.h"

namespace lume::shading {

std::size_t Image::memory_bytes() const {
  return std::visit([](const auto& values) { return values.size() * sizeof(*values.data()); },
                    texels);
}

}  // namespace lume::shading
