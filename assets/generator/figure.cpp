// SPDX-License-Identifier: Apache-2.0
#include "assets/generator/figure.h"

#include "assets/generator/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lume::generator {
namespace {

using geometry::Vec3;

/// A cone between two spheres, blended with what came before it over `blend` metres.
struct Limb {
  Vec3 a;
  Vec3 b;
  float radius_a;
  float radius_b;
  float blend;
};

/// The right half where x > 0; the left one is its mirror image.
constexpr std::array<Limb, 17> k_limbs = {{
    {{0, 0.00f, 0}, {0, 0.90f, 0}, 0.30f, 0.19f, 0.0f},                           // robe
    {{0, 0.90f, 0}, {0, 1.12f, 0.01f}, 0.19f, 0.145f, 0.08f},                     // hips to waist
    {{0, 1.12f, 0.01f}, {0, 1.30f, 0.02f}, 0.145f, 0.17f, 0.08f},                 // chest
    {{0.05f, 1.36f, 0}, {0.17f, 1.37f, -0.01f}, 0.085f, 0.075f, 0.08f},           // shoulder
    {{0.075f, 1.25f, 0.12f}, {0.075f, 1.25f, 0.12f}, 0.07f, 0.07f, 0.06f},        // breast
    {{0.20f, 1.36f, -0.01f}, {0.235f, 1.12f, 0.00f}, 0.062f, 0.055f, 0.04f},      // upper arm
    {{0.235f, 1.12f, 0.00f}, {0.06f, 1.10f, 0.20f}, 0.055f, 0.036f, 0.03f},       // forearm
    {{0.06f, 1.10f, 0.20f}, {0.00f, 1.12f, 0.235f}, 0.034f, 0.028f, 0.02f},       // hand
    {{0, 1.38f, -0.01f}, {0, 1.56f, 0.01f}, 0.065f, 0.058f, 0.06f},               // neck
    {{0, 1.60f, 0.035f}, {0, 1.70f, 0.00f}, 0.078f, 0.104f, 0.04f},               // head
    {{0, 1.572f, 0.085f}, {0, 1.58f, 0.08f}, 0.026f, 0.026f, 0.04f},              // chin
    {{0, 1.665f, 0.118f}, {0, 1.627f, 0.136f}, 0.010f, 0.016f, 0.018f},           // nose
    {{0.012f, 1.688f, 0.108f}, {0.055f, 1.686f, 0.088f}, 0.013f, 0.011f, 0.02f},  // brow
    {{0.0f, 1.602f, 0.117f}, {0.02f, 1.603f, 0.110f}, 0.011f, 0.008f, 0.012f},    // lips
    {{0.034f, 1.664f, 0.093f}, {0.034f, 1.664f, 0.093f}, 0.0145f, 0.0145f, 0.006f},  // eye
    {{0.05f, 1.635f, 0.07f}, {0.05f, 1.635f, 0.07f}, 0.028f, 0.028f, 0.03f},         // cheek
    {{0, 1.70f, -0.10f}, {0, 1.69f, -0.13f}, 0.065f, 0.055f, 0.025f},  // hair in a knot
}};

float distance_to(const Limb& limb, const Vec3& p) {
  const Vec3 axis = limb.b - limb.a;
  const float size = std::max(dot(axis, axis), 1e-12f);
  const float t = std::clamp(dot(p - limb.a, axis) / size, 0.0f, 1.0f);
  return length(p - limb.a - t * axis) - glm::mix(limb.radius_a, limb.radius_b, t);
}

/// What distance_to() is at least for points of that height.
float least_distance(const Limb& limb, float height) {
  const float below = std::min(limb.a.y, limb.b.y) - height;
  const float above = height - std::max(limb.a.y, limb.b.y);
  return std::max(below, above) - std::max(limb.radius_a, limb.radius_b);
}

/// The lesser of two distances, rounded where they are within k of each other (Quilez 2013, "Smooth
/// minimum", the quadratic polynomial).
float smooth_min(float a, float b, float k) {
  const float h = std::max(k - std::abs(a - b), 0.0f);
  return std::min(a, b) - (k > 0.0f ? h * h / (4.0f * k) : 0.0f);
}

float smooth_step(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

/// Ridges of cloth: noise with its valleys turned into creases, in [0, 1] or so.
float creases(const Vec3& p, std::uint64_t seed) { return 1.0f - std::abs(noise(p, seed)); }

/// Folds hang from the hips: they run along y and grow downwards, bent a little by slow noise.
float folds(const Vec3& p) {
  const float robe = 1.0f - smooth_step(0.35f, 1.08f, p.y);
  if (robe == 0.0f) return 0.0f;
  const float radius = std::sqrt(p.x * p.x + p.z * p.z + 1e-4f);
  const float sway = 0.5f * noise(1.5f * p, 11);
  const Vec3 folded(2.2f * p.x / radius + sway, 0.55f * p.y, 2.2f * p.z / radius);
  return 0.085f * robe * (creases(folded, 12) + 0.4f * creases(2.3f * folded, 13) - 1.0f);
}

/// The bodice wrinkles across.
float wrinkles(const Vec3& p) {
  const float bodice = smooth_step(0.9f, 1.05f, p.y) * (1.0f - smooth_step(1.36f, 1.46f, p.y));
  if (bodice == 0.0f) return 0.0f;
  return 0.01f * bodice * creases(Vec3(5.0f, 14.0f, 5.0f) * p, 14);
}

/// Hair over the skull, behind a line that climbs to the forehead.
float strands(const Vec3& p) {
  const float hair = smooth_step(-0.01f, 0.02f, 0.6f * (p.y - 1.70f) - p.z + 0.035f) *
                     smooth_step(1.55f, 1.62f, p.y);
  if (hair == 0.0f) return 0.0f;
  return 0.007f * hair * (1.0f + creases(Vec3(90.0f, 18.0f, 26.0f) * p, 15));
}

/// The stone's surface, from a hand's breadth down to millimetres, less on the face.
float stone(const Vec3& p) {
  const float rough = 1.0f - 0.75f * smooth_step(1.48f, 1.55f, p.y);
  return 0.0035f * rough * fractal_noise(12.0f * p, 6, 0.5f, 16);
}

}  // namespace

float figure_distance(const Vec3& p) {
  const Vec3 mirrored(std::abs(p.x), p.y, p.z);
  float distance = std::numeric_limits<float>::infinity();
  for (const Limb& limb : k_limbs) {
    if (least_distance(limb, mirrored.y) >= distance + limb.blend) continue;  // changes nothing
    distance = smooth_min(distance, distance_to(limb, mirrored), limb.blend);
  }
  return distance;
}

float figure_relief(const Vec3& p) { return folds(p) + wrinkles(p) + strands(p) + stone(p); }

}  // namespace lume::generator
