// SPDX-License-Identifier: Apache-2.0
// Ray casting (Appel 1968, "Some Techniques for Shading Machine Renderings of Solids"): the first
// surface along the ray, lit by the lights that a shadow ray finds free, and nothing behind or
// mirrored in it:
//   I = emitted + L_a k_a O_a + sum over lights f_att L_p (k_d O_d (n.l) + k_s O_s (r.v)^n).
#include "renderer/integrators/raycast.h"

#include "renderer/branch.h"

namespace lume::renderer {
namespace {

class Raycast final : public Integrator {
 public:
  Raycast(const PreparedScene& prepared, const IntegratorSettings& settings)
      : prepared_(prepared), settings_(settings) {}

  Radiance radiance(const geometry::Ray& ray, const Sampler& sampler,
                    Ledger& ledger) const override {
    ++ledger.counts.camera;
    return follow(prepared_, {.ray = ray, .aim = {}}, sampler, ledger,
                  [&](const Branch& branch, const geometry::SurfacePoint& point,
                      const shading::MaterialPoint& material, const Sampler& layer,
                      SurfaceNote* note, Radiance& result) {
                    const shading::Bsdf bsdf(material, -branch.ray.direction, false);
                    local_light(prepared_, branch, {point, material, bsdf, false}, settings_, layer,
                                ledger, note, result);
                  });
  }

 private:
  const PreparedScene& prepared_;
  IntegratorSettings settings_;
};

}  // namespace

std::unique_ptr<Integrator> make_raycast(const PreparedScene& prepared,
                                         const IntegratorSettings& settings) {
  return std::make_unique<Raycast>(prepared, settings);
}

}  // namespace lume::renderer
