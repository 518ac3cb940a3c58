// SPDX-License-Identifier: Apache-2.0
#include "assets/generator/characters.h"

#include <array>

namespace lume::generator {

std::span<const Character> characters() {
  static constexpr std::array<Character, 4> k_characters = {{
      {"architecture",
       "an open atrium: columns, arches, balustrades, stairs",
       &architecture,
       {-11.7f, 6.6f, 1.2f},
       {3.0f, 4.6f, -0.8f},
       1.2f,
       {-0.45f, 1.0f, 0.2f}},
      {"statue",
       "a dense, closed figure on a plinth",
       &statue,
       {1.5f, 1.6f, 4.6f},
       {0.0f, 1.14f, 0.0f},
       0.56f,
       {-0.8f, 0.9f, 0.7f}},
      {"stadium",
       "a dense teapot in a stadium of few triangles",
       &stadium,
       {0.24f, 1.04f, 0.52f},
       {0.0f, 1.02f, 0.0f},
       0.8f,
       {-0.65f, 0.75f, 0.45f}},
      {"hair",
       "thousands of wavy strands on a ball",
       &hair,
       {0.6f, 0.6f, 3.1f},
       {0.0f, -0.17f, 0.0f},
       0.7f,
       {-0.7f, 1.0f, 0.8f}},
  }};
  return k_characters;
}

}  // namespace lume::generator
