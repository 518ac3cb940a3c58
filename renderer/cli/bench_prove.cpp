// SPDX-License-Identifier: Apache-2.0
// `lume bench --prove`: structures that agree give one picture, to the last bit.
#include "renderer/bench/prove.h"

#include "io/ray_file.h"
#include "renderer/cli/bench_modes.h"
#include "renderer/cli/bench_report.h"
#include "renderer/cli/render_stats.h"
#include "renderer/cli/result_output.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <xxhash.h>

#include <algorithm>

namespace lume::cli {
namespace {

using renderer::ProofOfOne;

constexpr int k_default_width = 320;

/// XXH3 of 128 bits over the film's floats.
std::string hash_of(const renderer::Film& film) {
  const XXH128_hash_t hash =
      XXH3_128bits(film.pixels.data(), film.pixels.size() * sizeof(film.pixels[0]));
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

/// One scene rendered through all structures, and what is to be told of it.
class SceneProof {
 public:
  SceneProof(const BenchOptions& options, bool many_scenes)
      : options_(options), many_scenes_(many_scenes), loaded_(load_scene(options)) {}

  /// The text for stdout; `agree` turns false if a structure differs.
  std::string run(bool& agree);

 private:
  std::string tell(const std::vector<ProofOfOne>& proofs, const Viewpoint& view);
  std::string tell_mismatch(const ProofOfOne& proof);
  std::string mismatch_file(const std::string& structure) const;

  const BenchOptions& options_;
  bool many_scenes_;
  io::LoadedScene loaded_;
  std::vector<io::RayList> rays_;  ///< for --save-mismatch
};

std::string SceneProof::run(bool& agree) {
  Viewpoint view = choose_viewpoint(loaded_.scene, options_);
  (void)light_scene(options_, loaded_.scene);
  focus(view, options_,
        renderer::PreparedScene(loaded_.scene, geometry::accelerator_names().front()));
  renderer::ProofSettings settings;
  settings.render = {pixel_settings(options_, view.size), {}, {}};
  settings.integrator = options_.integrator;
  settings.method = integrator_settings(options_);
  Progress progress(stderr, bench_progress_style(options_));
  const Stopwatch watch;
  settings.on_progress = [&](double fraction) { progress.update(fraction, watch.elapsed()); };
  const auto proofs = prove(loaded_.scene, view.camera.camera,
                            name_candidates(options_.accelerators, view, {}), settings);
  progress.clear();
  agree = agree && std::none_of(proofs.begin(), proofs.end(),
                                [](const auto& proof) { return proof.mismatch.has_value(); });
  return tell(proofs, view);
}

std::string SceneProof::tell(const std::vector<ProofOfOne>& proofs, const Viewpoint& view) {
  std::string text = fmt::format("{}: {}x{} pixels, {} sample{} each, {}\n",
                                 printable(options_.scene_file), view.size.width, view.size.height,
                                 options_.spp, options_.spp == 1 ? "" : "s", options_.integrator);
  std::size_t width = 0;
  for (const ProofOfOne& proof : proofs) width = std::max(width, proof.name.size());
  for (const ProofOfOne& proof : proofs) {
    text += fmt::format("  {:<{}}  {}", printable(proof.name), width, hash_of(proof.film));
    if (proof.mismatch) {
      text += fmt::format(
          "  differs in {} pixel{}, first at {},{}", format_count(proof.mismatch->pixels),
          proof.mismatch->pixels == 1 ? "" : "s", proof.mismatch->x, proof.mismatch->y);
    }
    text += "\n";
  }
  std::size_t differing = 0;
  for (const ProofOfOne& proof : proofs) {
    if (!proof.mismatch) continue;
    ++differing;
    text += tell_mismatch(proof);
  }
  if (differing == 0) return text + fmt::format("all {} structures agree\n", proofs.size());
  return text + fmt::format("{} of {} structures differ from {}\n", differing, proofs.size(),
                            printable(proofs.front().name));
}

std::string SceneProof::tell_mismatch(const ProofOfOne& proof) {
  const std::string& first = options_.accelerators.front();
  const renderer::Mismatch& mismatch = *proof.mismatch;
  std::string text = fmt::format("\n{} and {}, pixel {},{}: ", printable(first),
                                 printable(proof.name), mismatch.x, mismatch.y);
  if (!mismatch.ray) {
    return text +
           "no ray is answered differently when it is rendered again, on one thread: a "
           "structure does not always give the same answer\n";
  }
  // Where a hit lies follows from the primitive, whichever structure is there.
  const renderer::PreparedScene prepared(loaded_.scene, geometry::accelerator_names().front());
  text += fmt::format(
      "the first ray on which they differ ({})\n{}",
      mismatch.ray->any_hit ? "any hit" : "closest hit",
      describe_disagreement(*mismatch.ray, printable(first), printable(proof.name), prepared));
  const io::RayList list{
      short_name(proof.name).substr(0, 64), mismatch.ray->any_hit, false, {mismatch.ray->ray}};
  const std::string file = mismatch_file(proof.name);
  rays_.push_back(list);
  io::write_rays(file, options_.save_mismatch ? rays_ : std::vector{list});
  return text + fmt::format("  again: lume bench {} --accelerators {},{} --replay {}\n",
                            shell_quote(printable(options_.scene_file)), printable(first),
                            shell_quote(printable(proof.name)), shell_quote(printable(file)));
}

std::string SceneProof::mismatch_file(const std::string& structure) const {
  if (options_.save_mismatch) return *options_.save_mismatch;
  const std::string scene =
      many_scenes_ ? std::filesystem::path(options_.scene_file).stem().string() + "-" : "";
  return "mismatch-" + scene + short_name(structure) + ".rays";
}

}  // namespace

ExitCode run_prove(const BenchOptions& options) {
  bool agree = true;
  for (const std::string& file : options.scene_files) {
    const BenchOptions of_scene = options_for(options, file, k_default_width);
    print_result(SceneProof(of_scene, options.scene_files.size() > 1).run(agree));
  }
  return agree ? ExitCode::success : ExitCode::disagreement;
}

}  // namespace lume::cli
