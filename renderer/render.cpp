// SPDX-License-Identifier: Apache-2.0
#include "renderer/render.h"

#include "geometry/parallel.h"

#include <algorithm>
#include <mutex>
#include <tuple>

namespace lume::renderer {
namespace {

constexpr int k_tile_size = 16;  // pixels; small enough that the last tiles keep all threads busy

/// The AOVs by where they come from.
struct AovGroups {
  std::vector<Aov> center;
  std::vector<Aov> surface;
  std::vector<Aov> light;
};

/// What is the same for all tiles.
struct Job {
  const PreparedScene& prepared;
  const geometry::Camera& camera;
  const Integrator& integrator;
  const RenderSettings& settings;
  const std::atomic<bool>* cancel = nullptr;
  AovGroups aovs;

  [[nodiscard]] bool is_cancelled() const {
    return cancel != nullptr && cancel->load(std::memory_order_relaxed);
  }
};

/// What a tile counts besides its pixels.
struct Tally {
  RayCounts rays;
  NonFiniteSamples non_finite;
  bool complete = true;

  void add_non_finite(const NonFiniteSamples& other) {
    if (other.count == 0) return;
    const auto place = [](const NonFiniteSamples& n) { return std::tuple(n.y, n.x, n.sample); };
    if (non_finite.count == 0 || place(other) < place(non_finite)) {
      const std::uint64_t count = non_finite.count;
      non_finite = other;
      non_finite.count = count;
    }
    non_finite.count += other.count;
  }
};

/// Channels of one pixel's AOVs, kept from pixel to pixel so that none allocates.
struct PixelAovs {
  explicit PixelAovs(const AovGroups& groups)
      : center(channel_count(groups.center)),
        surface(channel_count(groups.surface)),
        light(channel_count(groups.light)),
        sample(surface.size()) {}

  std::vector<float> center;
  std::vector<float> surface;
  std::vector<float> light;
  std::vector<float> sample;  ///< what one sample adds to `surface`
};

/// The mean of a pixel's samples, and all its AOVs.
shading::Vec4 render_pixel(const Job& job, int x, int y, PixelAovs& aovs, Tally& tally) {
  const RenderSettings& settings = job.settings;
  PixelMean mean;
  std::fill(aovs.surface.begin(), aovs.surface.end(), 0.0f);
  for (std::uint32_t s = 0; s < settings.spp; ++s) {
    const auto [ray, sampler] = camera_sample(settings, job.camera, x, y, s);
    Ledger ledger;
    const Radiance sample = job.integrator.radiance(ray, sampler, ledger);
    if (!mean.add(sample, ledger.counts.total())) tally.add_non_finite({1, x, y, s});
    tally.rays += ledger.counts;
    if (aovs.surface.empty()) continue;
    evaluate_aovs(job.aovs.surface, job.prepared, job.camera, ray, aovs.sample);
    for (std::size_t i = 0; i < aovs.sample.size(); ++i) aovs.surface[i] += aovs.sample[i];
  }
  const float scale = 1.0f / static_cast<float>(settings.spp);
  for (float& value : aovs.surface) value *= scale;
  const PixelLight light = mean.light(settings.spp);
  evaluate_light_aovs(job.aovs.light, light, aovs.light);
  if (!aovs.center.empty()) {
    evaluate_aovs(job.aovs.center, job.prepared, job.camera, center_ray(settings, job.camera, x, y),
                  aovs.center);
  }
  return {light.mean.color(), light.mean.alpha};
}

/// Copies a group's interleaved channels into the film's layers at one pixel.
void store_layers(Film& film, std::span<const Aov> group, std::span<const float> values,
                  std::size_t pixel) {
  const float* next = values.data();
  for (const Aov aov : group) {
    const std::size_t channels = aov_infos()[static_cast<std::size_t>(aov)].channels.size();
    for (Film::Layer& layer : film.layers) {
      if (layer.aov == aov) std::copy_n(next, channels, &layer.values[pixel * channels]);
    }
    next += channels;
  }
}

Tally render_tile(const Job& job, const shading::PixelRegion& tile, Film& film) {
  Tally tally;
  PixelAovs aovs(job.aovs);
  for (int y = tile.y; y < tile.y + tile.height; ++y) {
    for (int x = tile.x; x < tile.x + tile.width; ++x) {
      if (job.is_cancelled()) {  // once a pixel: with many samples a tile takes minutes
        tally.complete = false;
        return tally;
      }
      const auto pixel = static_cast<std::size_t>(y - film.region.y) *
                             static_cast<std::size_t>(film.region.width) +
                         static_cast<std::size_t>(x - film.region.x);
      film.pixels[pixel] = render_pixel(job, x, y, aovs, tally);
      store_layers(film, job.aovs.center, aovs.center, pixel);
      store_layers(film, job.aovs.surface, aovs.surface, pixel);
      store_layers(film, job.aovs.light, aovs.light, pixel);
    }
  }
  return tally;
}

Film empty_film(const RenderSettings& settings) {
  Film film;
  film.region = settings.region;
  if (film.region == shading::PixelRegion{}) film.region = {0, 0, settings.width, settings.height};
  const auto count =
      static_cast<std::size_t>(film.region.width) * static_cast<std::size_t>(film.region.height);
  film.pixels.assign(count, shading::Vec4(0.0f));
  for (const Aov aov : settings.aovs) {
    film.layers.push_back({aov, std::vector<float>(count * channel_count({&aov, 1}))});
  }
  return film;
}

std::vector<shading::PixelRegion> cut_tiles(const shading::PixelRegion& region) {
  std::vector<shading::PixelRegion> tiles;
  for (int y = 0; y < region.height; y += k_tile_size) {
    for (int x = 0; x < region.width; x += k_tile_size) {
      tiles.push_back({region.x + x, region.y + y, std::min(k_tile_size, region.width - x),
                       std::min(k_tile_size, region.height - y)});
    }
  }
  return tiles;
}

AovGroups group_aovs(const std::vector<Aov>& aovs) {
  AovGroups groups;
  for (const Aov aov : aovs) {
    const AovSource source = aov_infos()[static_cast<std::size_t>(aov)].source;
    (source == AovSource::center    ? groups.center
     : source == AovSource::surface ? groups.surface
                                    : groups.light)
        .push_back(aov);
  }
  return groups;
}

}  // namespace

RenderResult render_image(const PreparedScene& prepared, const geometry::Camera& camera,
                          const Integrator& integrator, const RenderSettings& settings,
                          const RenderControl& control) {
  RenderResult result{.film = empty_film(settings), .rays = {}, .non_finite = {}};
  const Job job{prepared, camera, integrator, settings, control.cancel, group_aovs(settings.aovs)};
  const auto tiles = cut_tiles(result.film.region);

  std::mutex mutex;  // taken once a tile
  Tally total;
  std::size_t done = 0;
  geometry::parallel_for(
      tiles.size(),
      [&](std::size_t i) {
        const Tally tally = render_tile(job, tiles[i], result.film);
        const std::lock_guard lock(mutex);
        total.rays += tally.rays;
        total.add_non_finite(tally.non_finite);
        if (!tally.complete) return;
        ++done;
        if (control.on_progress) {
          control.on_progress(static_cast<double>(done) / static_cast<double>(tiles.size()));
        }
      },
      control.cancel);

  result.rays = total.rays;
  result.non_finite = total.non_finite;
  result.cancelled = done < tiles.size();
  return result;
}

}  // namespace lume::renderer
