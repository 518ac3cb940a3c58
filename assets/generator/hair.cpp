// SPDX-License-Identifier: Apache-2.0
// A ball of hair. Strands are long and thin, run in all directions and through each other, so their
// boxes are nearly empty and overlap wherever a hierarchy divides them.
#include "assets/generator/characters.h"
#include "assets/generator/fit_detail.h"
#include "assets/generator/hash.h"
#include "assets/generator/mesh_builder.h"
#include "assets/generator/noise.h"

#include <array>
#include <cmath>
#include <numbers>

namespace lume::generator {
namespace {

constexpr float k_ball = 0.36f;  // metres
constexpr std::uint32_t k_sides = 3;

/// What the random numbers of a strand are for.
enum Purpose : std::uint64_t { length_of_strand, phase, curl, offset_x, offset_y, offset_z };

/// How many strands there are, and how they are divided.
struct HairDetail {
  std::uint32_t strands = 8;
  std::uint32_t segments = 4;
  std::uint32_t ball = 4;  ///< rows of the ball, which has twice as many columns

  [[nodiscard]] static HairDetail of(std::size_t triangles);
  /// The ball's surface is covered alike by few and by many strands.
  [[nodiscard]] float strand_radius() const {
    return 0.42f * k_ball / std::sqrt(static_cast<float>(strands));
  }
};

HairDetail HairDetail::of(std::size_t triangles) {
  const double detail = static_cast<double>(triangles) / 1000.0;
  HairDetail result;
  result.segments = segments_at(5.0, detail, 0.22);
  result.ball = segments_at(4.0, detail, 0.25);
  const std::size_t of_ball = 4 * std::size_t{result.ball} * (result.ball - 1);
  const std::size_t of_strand = 2 * std::size_t{k_sides} * result.segments;
  result.strands = static_cast<std::uint32_t>((triangles - of_ball) / of_strand);
  return result;
}

/// Point `number` of `count` that are evenly spread over the unit sphere: a Fibonacci lattice
/// (Keinert et al. 2015, "Spherical Fibonacci Mapping").
Vec3 spread(std::uint32_t number, std::uint32_t count) {
  constexpr double k_golden = 0.6180339887498949;
  const double z = 1.0 - (2.0 * number + 1.0) / count;
  const double turns = std::fmod(number * k_golden, 1.0);
  const double radius = std::sqrt(1.0 - z * z);
  const double angle = 2.0 * std::numbers::pi * turns;
  return {radius * std::cos(angle), z, radius * std::sin(angle)};
}

/// One strand's path.
class Strand {
 public:
  Strand(std::uint32_t number, const HairDetail& detail)
      : number_(number),
        root_(normalize(spread(number, detail.strands) +
                        0.5f / std::sqrt(static_cast<float>(detail.strands)) * jitter_of(number))),
        length_(0.75f + 0.5f * random_unit(number, length_of_strand)) {
    // Strands near each other lean to the same side: locks, at two scales.
    frame_ = geometry::make_frame(root_);
    lean_ = Vec3(noise(3.0f * root_, 31), noise(3.0f * root_, 32), noise(3.0f * root_, 33));
    lock_ = Vec3(noise(9.0f * root_, 41), noise(9.0f * root_, 42), noise(9.0f * root_, 43));
  }

  /// The middle of the strand at t from 0 (root) to 1 (tip).
  [[nodiscard]] Vec3 at(float t) const {
    const float s = length_ * t;
    const Vec3 straight = (k_ball + 0.8f * s * (1.0f - 0.3f * t)) * root_;
    const Vec3 fall = Vec3(0, -0.42f, 0) * (s * s);
    const Vec3 tuft = 0.45f * s * t * lean_ + 0.3f * s * lock_;
    return straight + fall + tuft + wave(t);
  }

  /// Two unit vectors across the path. A strand falls within the plane of its root and +y, so what
  /// is normal to that plane is across it nearly everywhere and turns little.
  [[nodiscard]] std::array<Vec3, 2> across(float t, float step) const {
    const Vec3 along = normalize(at(t + step) - at(t - step));
    const Vec3 level = cross(root_, Vec3(0.01f, 1.0f, 0.0f));
    const Vec3 side = normalize(cross(level, along));
    return {side, cross(along, side)};
  }

 private:
  static Vec3 jitter_of(std::uint32_t number) {
    return {random_signed(number, offset_x), random_signed(number, offset_y),
            random_signed(number, offset_z)};
  }
  /// A helix around the path that widens to the tip; a lock's strands are nearly in step.
  [[nodiscard]] Vec3 wave(float t) const {
    const float angle = 2.0f * geometry::k_pi *
                        (2.5f * length_ * t + lock_.x + 0.25f * random_unit(number_, phase));
    const float width = 0.06f * t * (0.4f + random_unit(number_, curl));
    return width * (std::cos(angle) * frame_.tangent + std::sin(angle) * frame_.bitangent);
  }

  std::uint32_t number_;
  Vec3 root_;
  geometry::Frame frame_{};  ///< its normal is the root's
  float length_;
  Vec3 lean_{0.0f};
  Vec3 lock_{0.0f};
};

/// A three-sided tube that thins out to the tip. Both ends are open: one is in the ball, and the
/// other too thin to be looked into.
void add_strand(MeshBuilder& builder, const HairDetail& detail, std::uint32_t number) {
  const Strand strand(number, detail);
  const float radius = detail.strand_radius();
  const float step = 0.5f / static_cast<float>(detail.segments);
  builder.add_sheet({k_sides, detail.segments}, [&](float u, float v) {
    const auto [side, other] = strand.across(v, step);
    const Vec2 around = MeshBuilder::around(u);
    return strand.at(v) + radius * (1.0f - 0.8f * v) * (around.y * side + around.x * other);
  });
}

void add_all(MeshBuilder& builder, const HairDetail& detail) {
  builder.add_lathe({2 * detail.ball, detail.ball, Poles::both}, [](float v) {
    const float angle = geometry::k_pi * v;
    return k_ball * Vec2(v == 1.0f ? 0.0f : std::sin(angle), -std::cos(angle));
  });
  for (std::uint32_t strand = 0; strand < detail.strands; ++strand) {
    add_strand(builder, detail, strand);
  }
}

}  // namespace

geometry::Mesh hair(std::size_t triangles) {
  const HairDetail detail = HairDetail::of(triangles);
  MeshBuilder counter;
  add_all(counter, detail);
  MeshBuilder builder = MeshBuilder::with_room_for(counter);
  add_all(builder, detail);
  return builder.take();
}

}  // namespace lume::generator
