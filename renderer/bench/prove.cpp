// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/prove.h"

#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace lume::renderer {
namespace {

class Prover {
 public:
  Prover(const shading::Scene& scene, const geometry::Camera& camera, const ProofSettings& settings)
      : scene_(scene), camera_(camera), settings_(settings) {}

  [[nodiscard]] Film render(const Candidate& candidate,
                            const std::function<void(double)>& on_progress) const;
  [[nodiscard]] std::optional<Mismatch> find_mismatch(const Candidate& first,
                                                      const Candidate& other,
                                                      const Film& first_film,
                                                      const Film& other_film) const;

 private:
  [[nodiscard]] std::optional<Disagreement> find_ray(const Candidate& first, const Candidate& other,
                                                     int x, int y) const;

  const shading::Scene& scene_;
  const geometry::Camera& camera_;
  const ProofSettings& settings_;
};

Film Prover::render(const Candidate& candidate,
                    const std::function<void(double)>& on_progress) const {
  PreparedScene prepared(scene_, candidate.make);
  prepared.prepare_view(camera_, settings_.render.width, settings_.render.height);
  const auto integrator = make_integrator(settings_.integrator, prepared, settings_.method);
  return render_image(prepared, camera_, *integrator, settings_.render, {on_progress, nullptr})
      .film;
}

/// Bits and not values: a NaN is equal to itself here, and 0 is not -0.
bool are_same(const shading::Vec4& a, const shading::Vec4& b) {
  using Bits = std::array<std::uint32_t, 4>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

std::optional<Mismatch> Prover::find_mismatch(const Candidate& first, const Candidate& other,
                                              const Film& first_film,
                                              const Film& other_film) const {
  Mismatch mismatch;
  const auto width = static_cast<std::size_t>(first_film.region.width);
  for (std::size_t i = 0; i < first_film.pixels.size(); ++i) {
    if (are_same(first_film.pixels[i], other_film.pixels[i])) continue;
    if (mismatch.pixels++ > 0) continue;
    mismatch.x = first_film.region.x + static_cast<int>(i % width);
    mismatch.y = first_film.region.y + static_cast<int>(i / width);
  }
  if (mismatch.pixels == 0) return std::nullopt;
  mismatch.ray = find_ray(first, other, mismatch.x, mismatch.y);
  return mismatch;
}

std::optional<Disagreement> Prover::find_ray(const Candidate& first, const Candidate& other, int x,
                                             int y) const {
  const Witness* witness = nullptr;
  PreparedScene prepared(
      scene_, [&](const geometry::World& world, const geometry::HoleTest* holes) {
        auto both = std::make_unique<Witness>(first.make(world, holes), other.make(world, holes));
        witness = both.get();
        return both;
      });
  prepared.prepare_view(camera_, settings_.render.width, settings_.render.height);
  const auto integrator = make_integrator(settings_.integrator, prepared, settings_.method);
  for (std::uint32_t s = 0; s < settings_.render.spp; ++s) {
    const CameraSample sample = camera_sample(settings_.render, camera_, x, y, s);
    Ledger ledger;
    (void)integrator->radiance(sample.ray, sample.sampler, ledger);
    if (witness->first_disagreement()) return witness->first_disagreement();
  }
  return std::nullopt;
}

}  // namespace

std::vector<ProofOfOne> prove(const shading::Scene& scene, const geometry::Camera& camera,
                              std::span<const Candidate> candidates,
                              const ProofSettings& settings) {
  const Prover prover(scene, camera, settings);
  std::vector<ProofOfOne> proofs;
  proofs.reserve(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto tell = [&](double fraction) {
      if (!settings.on_progress) return;
      settings.on_progress((static_cast<double>(i) + fraction) /
                           static_cast<double>(candidates.size()));
    };
    ProofOfOne& proof = proofs.emplace_back();
    proof.name = candidates[i].name;
    proof.film = prover.render(candidates[i], tell);
    proof.mismatch = prover.find_mismatch(candidates[0], candidates[i], proofs[0].film, proof.film);
  }
  return proofs;
}

}  // namespace lume::renderer
