// SPDX-License-Identifier: Apache-2.0
#include "renderer/integrator.h"

#include "renderer/integrators/raycast.h"
#include "renderer/integrators/whitted.h"

#include <array>
#include <stdexcept>
#include <string>

namespace lume::renderer {
namespace {

constexpr std::array<std::string_view, 2> k_names = {"whitted", "raycast"};

}  // namespace

std::span<const std::string_view> integrator_names() { return k_names; }

std::unique_ptr<Integrator> make_integrator(std::string_view name, const PreparedScene& prepared,
                                            const IntegratorSettings& settings) {
  if (name == "whitted") return make_whitted(prepared, settings);
  if (name == "raycast") return make_raycast(prepared, settings);
  throw std::invalid_argument("unknown integrator: " + std::string(name));
}

}  // namespace lume::renderer
