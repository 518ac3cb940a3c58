// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/ray_sets.h"

#include "renderer/bench/ray_aim.h"
#include "renderer/pixel.h"
#include "shading/warp.h"

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <utility>

namespace lume::renderer {
namespace {

using geometry::Ray;
using geometry::SurfacePoint;

constexpr std::array<RaySetInfo, 5> k_infos = {{
    {RaySetKind::primary, "primary", false, true, "from the camera, in blocks of 4x4 pixels"},
    {RaySetKind::shadow, "shadow", true, true, "from what they meet to the lights, block by block"},
    {RaySetKind::diffuse, "diffuse", false, false, "reflected there by the cosine"},
    {RaySetKind::bounce2, "bounce2", false, false, "reflected once more, shuffled"},
    {RaySetKind::ao, "ao", true, false, "by the cosine and of limited length, shuffled"},
}};

/// The random numbers of the sets, by what they are for: dimensions of a Sampler whose "pixel" is
/// (number of the ray's start, k_place_row) or (number of the block, k_block_row). Rows of pixels
/// are never negative.
enum Row : int { k_place_row = -1, k_block_row = -2 };
enum Dimension : std::uint32_t { k_diffuse, k_bounce2, k_ao };

/// A surface that a ray of an earlier set met, and the number of that ray's block.
struct Place {
  SurfacePoint point;
  std::size_t block = 0;
};

/// Fisher and Yates' shuffle; std::shuffle is another one in every library.
void shuffle(std::vector<Ray>& rays, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (std::size_t i = rays.size(); i > 1; --i) std::swap(rays[i - 1], rays[random() % i]);
}

class Recorder {
 public:
  Recorder(const PreparedScene& prepared, const geometry::Camera& camera,
           const RaySetSettings& settings)
      : prepared_(prepared), camera_(camera), settings_(settings), aim_(prepared) {}

  RaySet record(RaySetKind kind);

 private:
  /// Camera rays, made with the first set that builds on them.
  const std::vector<Ray>& primary();
  const std::vector<Ray>& diffuse();
  const std::vector<Place>& seen();
  [[nodiscard]] std::vector<Ray> shadow();
  [[nodiscard]] std::vector<Place> places_of(const std::vector<Ray>& rays) const;
  [[nodiscard]] std::vector<Ray> scatter(const std::vector<Place>& places, Dimension dimension,
                                         float length) const;
  [[nodiscard]] float ao_distance() const;

  /// Calls make(place, number of the ray from there) until there are settings.count rays, from all
  /// places as evenly as can be, so that no part of the picture counts for more than another.
  template <class Make>
  [[nodiscard]] std::vector<Ray> from_each(std::size_t places, const Make& make) const {
    std::vector<Ray> rays;
    if (places == 0) return rays;
    rays.reserve(settings_.count);
    for (std::size_t i = 0, next = 0; i < settings_.count; ++next) {
      const std::size_t end = (next + 1) * settings_.count / places;
      for (std::uint32_t sample = 0; i < end; ++i) rays.push_back(make(next, sample++));
    }
    return rays;
  }

  const PreparedScene& prepared_;
  const geometry::Camera& camera_;
  const RaySetSettings& settings_;
  RayAim aim_;
  std::optional<std::vector<Ray>> primary_;
  std::optional<std::vector<Ray>> diffuse_;
  std::optional<std::vector<Place>> seen_;
};

const std::vector<Ray>& Recorder::primary() {
  if (primary_) return *primary_;
  const PixelSettings pixels{settings_.width, settings_.height, 1, settings_.seed,
                             PixelFilter(PixelFilter::Kind::box)};
  const auto across = static_cast<std::size_t>(std::max(1, settings_.width / 4));
  const auto blocks = across * static_cast<std::size_t>(std::max(1, settings_.height / 4));
  const std::size_t wanted = (settings_.count + k_batch_size - 1) / k_batch_size;
  const std::size_t passes = (wanted + blocks - 1) / blocks;
  std::vector<Ray>& rays = primary_.emplace();
  rays.reserve(wanted * k_batch_size);
  for (std::size_t i = 0; i < wanted; ++i) {
    // One of each stretch of blocks, and not always its first: that could be a column of the image.
    const std::size_t low = i * passes * blocks / wanted;
    const std::size_t high = (i + 1) * passes * blocks / wanted;
    const Sampler sampler(settings_.seed, static_cast<int>(i), k_block_row, 0);
    const float choice = sampler.get_1d(0) * static_cast<float>(high - low);
    const std::size_t chosen = std::min(low + static_cast<std::size_t>(choice), high - 1);
    const auto x = static_cast<int>(chosen % blocks % across) * 4;
    const auto y = static_cast<int>(chosen % blocks / across) * 4;
    const auto pass = static_cast<std::uint32_t>(chosen / blocks);
    for (int k = 0; k < static_cast<int>(k_batch_size); ++k) {
      const int column = std::min(x + k % 4, settings_.width - 1);
      const int row = std::min(y + k / 4, settings_.height - 1);
      rays.push_back(camera_sample(pixels, camera_, column, row, pass).ray);
    }
  }
  rays.resize(settings_.count);
  return rays;
}

std::vector<Place> Recorder::places_of(const std::vector<Ray>& rays) const {
  std::vector<Place> places;
  places.reserve(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto point = prepared_.first_surface(rays[i]);
    if (point) places.push_back({*point, i / k_batch_size});
  }
  return places;
}

const std::vector<Place>& Recorder::seen() {
  if (!seen_) seen_ = places_of(primary());
  return *seen_;
}

std::vector<Ray> Recorder::shadow() {
  struct Lit {
    const Place* place;
    std::size_t number;
  };
  std::vector<Lit> lit;
  const auto sampler = [&](std::size_t number, std::uint32_t sample) {
    return Sampler(settings_.seed, static_cast<int>(number), k_place_row, sample);
  };
  const std::vector<Place>& places = seen();
  lit.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (aim_.aim(places[i].point, places[i].block, sampler(i, 0))) lit.push_back({&places[i], i});
  }
  return from_each(lit.size(), [&](std::size_t i, std::uint32_t sample) {
    const Place& place = *lit[i].place;
    const auto ray = aim_.aim(place.point, place.block + sample, sampler(lit[i].number, sample));
    return ray ? *ray : *aim_.aim(place.point, place.block, sampler(lit[i].number, 0));
  });
}

std::vector<Ray> Recorder::scatter(const std::vector<Place>& places, Dimension dimension,
                                   float length) const {
  return from_each(places.size(), [&](std::size_t i, std::uint32_t sample) {
    const SurfacePoint& point = places[i].point;
    const Sampler sampler(settings_.seed, static_cast<int>(i), k_place_row, sample);
    const Vec3 normal = point.front_facing ? point.geometric_normal : -point.geometric_normal;
    Ray ray = leave(point, geometry::make_frame(normal).to_world(
                               shading::sample_cosine_hemisphere(sampler.get_2d(dimension))));
    ray.t_max = length;
    return ray;
  });
}

const std::vector<Ray>& Recorder::diffuse() {
  if (!diffuse_) diffuse_ = scatter(seen(), k_diffuse, Ray().t_max);
  return *diffuse_;
}

float Recorder::ao_distance() const {
  if (settings_.ao_distance > 0.0f) return settings_.ao_distance;
  const geometry::Bounds bounds = prepared_.scene().world.bounds();
  return bounds.is_finite() && bounds.radius() > 0.0f ? 0.2f * bounds.radius() : 1.0f;
}

RaySet Recorder::record(RaySetKind kind) {
  const RaySetInfo& info = k_infos[static_cast<std::size_t>(kind)];
  RaySet set{std::string(info.name), info.any_hit, info.coherent, {}};
  switch (kind) {
    case RaySetKind::primary:
      set.rays = primary();
      break;
    case RaySetKind::shadow:
      set.rays = shadow();
      break;
    case RaySetKind::diffuse:
      set.rays = diffuse();
      break;
    case RaySetKind::bounce2:
      set.rays = scatter(places_of(diffuse()), k_bounce2, Ray().t_max);
      shuffle(set.rays, settings_.seed);
      break;
    case RaySetKind::ao:
      set.rays = scatter(seen(), k_ao, ao_distance());
      shuffle(set.rays, settings_.seed);
      break;
  }
  return set;
}

}  // namespace

std::span<const RaySetInfo> ray_set_infos() { return k_infos; }

std::vector<RaySet> record_rays(const PreparedScene& prepared, const geometry::Camera& camera,
                                const RaySetSettings& settings, std::span<const RaySetKind> kinds) {
  Recorder recorder(prepared, camera, settings);
  std::vector<RaySet> sets;
  sets.reserve(kinds.size());
  for (const RaySetKind kind : kinds) sets.push_back(recorder.record(kind));
  return sets;
}

}  // namespace lume::renderer
