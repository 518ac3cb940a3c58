// SPDX-License-Identifier: Apache-2.0
#include "shading/material_point.h"

#include <algorithm>

namespace lume::shading {
namespace {

using geometry::SurfacePoint;

const Material& material_of(const Scene& scene, const SurfacePoint& point) {
  return scene.materials[point.geometry->material];
}

Vec4 read(const Scene& scene, const TextureUse& use, Encoding encoding, Vec2 texcoord) {
  const Texture& texture = scene.textures[use.texture];
  const Vec2 uv = use.transform.apply(texcoord);
  if (texture.checker) return texture.checker->value(uv);
  return sample_texture(texture, scene.images[texture.image], encoding, uv);
}

Vec4 read(const Scene& scene, const TextureUse& use, Encoding encoding, const SurfacePoint& point) {
  return read(scene, use, encoding, point.texcoord(use.texcoord));
}

/// glTF 2.0, section 3.9.4: what the alpha mode makes of an alpha value.
float coverage(const Material& material, float alpha) {
  switch (material.alpha_mode) {
    case AlphaMode::opaque:
      return 1.0f;
    case AlphaMode::mask:
      return alpha >= material.alpha_cutoff ? 1.0f : 0.0f;
    case AlphaMode::blend:
      return std::clamp(alpha, 0.0f, 1.0f);
  }
  return 1.0f;
}

/// The normal map's normal in the frame of the texture's coordinates (glTF 2.0, section 3.9.3).
Vec3 mapped_normal(const Scene& scene, const Material& material, const SurfacePoint& point) {
  if (!material.normal_texture) return point.normal;
  const Vec4 texel = read(scene, material.normal_texture, Encoding::linear, point);
  const Vec3 local(material.normal_scale * (2.0f * texel.x - 1.0f),
                   material.normal_scale * (2.0f * texel.y - 1.0f), 2.0f * texel.z - 1.0f);
  const geometry::Frame frame = tangent_frame(scene.world, point, material.normal_texture.texcoord,
                                              material.normal_texture.transform.linear());
  const Vec3 normal = frame.to_world(local);
  const float size = length(normal);
  return size > 1e-6f ? normal / size : point.normal;
}

/// What the metallic-roughness model needs besides the base colour.
void add_microfacet_factors(const Scene& scene, const Material& material, const SurfacePoint& point,
                            MaterialPoint& result) {
  result.metallic = material.metallic;
  result.roughness = material.roughness;
  if (material.metallic_roughness_texture) {
    const Vec4 texel = read(scene, material.metallic_roughness_texture, Encoding::linear, point);
    result.metallic *= texel.z;
    result.roughness *= texel.y;
  }
  result.transmission = material.transmission;
  if (material.transmission_texture) {
    result.transmission *= read(scene, material.transmission_texture, Encoding::linear, point).x;
  }
  result.specular = material.specular;
  if (material.specular_texture) {
    result.specular *= read(scene, material.specular_texture, Encoding::linear, point).w;
  }
  result.specular_color = material.specular_color;
  if (material.specular_color_texture) {
    result.specular_color *=
        Color(read(scene, material.specular_color_texture, Encoding::srgb, point));
  }
}

/// A viewer behind the horizon of an interpolated or mapped normal would see nothing but darkness:
/// the normal is bent just so far that it faces the viewer.
Vec3 face_viewer(const Vec3& normal, const Vec3& to_viewer) {
  constexpr float k_least_cosine = 1e-3f;
  const float cosine = dot(normal, to_viewer);
  if (cosine >= k_least_cosine) return normal;
  return normalize(normal + (k_least_cosine - cosine) * to_viewer);
}

}  // namespace

Vec4 evaluate_base_color(const Scene& scene, const SurfacePoint& point) {
  const Material& material = material_of(scene, point);
  Vec4 color = Vec4(material.base_color, material.alpha) * point.color();
  if (material.base_color_texture) {
    color *= read(scene, material.base_color_texture, Encoding::srgb, point);
  }
  return {color.x, color.y, color.z, coverage(material, color.w)};
}

float evaluate_coverage(const Scene& scene, const geometry::Hit& hit, Vec2 uv) {
  SurfacePoint point;  // only what texcoord() and color() look at
  point.hit = hit;
  point.geometry = &scene.world.geometry(hit);
  point.uv = uv;
  return evaluate_base_color(scene, point).w;
}

Color evaluate_emission(const Scene& scene, const SurfacePoint& point) {
  const Material& material = material_of(scene, point);
  if (!material.is_emissive() || !(point.front_facing || material.double_sided)) return Color(0.0f);
  if (!material.emission_texture) return material.emission;
  return material.emission * Color(read(scene, material.emission_texture, Encoding::srgb, point));
}

MaterialPoint evaluate_material(const Scene& scene, const SurfacePoint& point,
                                const Vec3& to_viewer) {
  const Material& material = material_of(scene, point);
  MaterialPoint result;
  result.material = &material;
  const Vec4 base_color = evaluate_base_color(scene, point);
  result.base_color = Color(base_color);
  result.coverage = base_color.w;
  if (!material.phong) add_microfacet_factors(scene, material, point, result);
  if (material.occlusion_texture) {
    const float texel = read(scene, material.occlusion_texture, Encoding::linear, point).x;
    result.occlusion = 1.0f + material.occlusion_strength * (texel - 1.0f);
  }
  const Vec3 normal = mapped_normal(scene, material, point);
  result.normal = face_viewer(point.front_facing ? normal : -normal, to_viewer);
  return result;
}

}  // namespace lume::shading
