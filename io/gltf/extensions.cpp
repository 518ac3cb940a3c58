// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/extensions.h"

#include "io/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace lume::io::gltf {
namespace {

constexpr auto k_known = std::to_array<KnownExtension>({
    {"EXT_mesh_gpu_instancing", Support::full, ""},
    {"EXT_meshopt_compression", Support::full, ""},
    {"EXT_texture_webp", Support::full, ""},
    {"KHR_animation_pointer", Support::ignored, "what it moves stays as it is"},
    {"KHR_draco_mesh_compression", Support::full, ""},
    {"KHR_implicit_shapes", Support::full, ""},
    {"KHR_lights_punctual", Support::full, ""},
    {"KHR_materials_anisotropy", Support::ignored, "highlights are round"},
    {"KHR_materials_clearcoat", Support::ignored, "the coat is left out"},
    {"KHR_materials_diffuse_transmission", Support::ignored, "no light passes through diffusely"},
    {"KHR_materials_dispersion", Support::ignored, "all colours are refracted alike"},
    {"KHR_materials_emissive_strength", Support::full, ""},
    {"KHR_materials_ior", Support::full, ""},
    {"KHR_materials_iridescence", Support::ignored, "the thin film is left out"},
    {"KHR_materials_pbrSpecularGlossiness", Support::ignored,
     "the metallic-roughness values are used"},
    {"KHR_materials_sheen", Support::ignored, "the sheen is left out"},
    {"KHR_materials_specular", Support::full, ""},
    {"KHR_materials_transmission", Support::full, ""},
    {"KHR_materials_unlit", Support::full, ""},
    {"KHR_materials_variants", Support::ignored, "the default materials are shown"},
    {"KHR_materials_volume", Support::partial,
     "the thickness decides between solid and thin; its texture is not read"},
    {"KHR_mesh_quantization", Support::full, ""},
    {"KHR_meshopt_compression", Support::full, ""},
    {"KHR_node_visibility", Support::full, ""},
    {"KHR_texture_basisu", Support::partial, "only the PNG or JPEG fallback is read"},
    {"KHR_texture_transform", Support::full, ""},
    {"KHR_xmp_json_ld", Support::ignored, "the metadata are not kept"},
    {"LUME_materials_phong", Support::full, ""},
    {"LUME_shape", Support::full, ""},
    {"LUME_texture_checker", Support::full, ""},
});

const KnownExtension* find_known(std::string_view name) {
  const auto it = std::find_if(k_known.begin(), k_known.end(),
                               [&](const KnownExtension& known) { return known.name == name; });
  return it == k_known.end() ? nullptr : &*it;
}

ExtensionUse describe(const std::string& name) {
  const KnownExtension* known = find_known(name);
  return known != nullptr ? ExtensionUse{name, known->support, std::string(known->remark), false}
                          : ExtensionUse{name, Support::ignored, "is not known to Lume", false};
}

}  // namespace

std::span<const KnownExtension> known_extensions() { return k_known; }

void check_required_extension(const JsonView& name) {
  const KnownExtension* known = find_known(name.text());
  if (known == nullptr) {
    std::vector<std::string> names;
    names.reserve(k_known.size());
    for (const KnownExtension& candidate : k_known) {
      names.emplace_back(candidate.name);
    }
    const std::string nearest = nearest_name(name.text(), names);
    name.fail(fmt::format("requires the extension '{}', which Lume does not know{}",
                          name.text().substr(0, 60),
                          nearest.empty() ? "" : "; the nearest it knows is " + nearest));
  }
  if (known->support == Support::ignored && known->is_vital) {
    name.fail(
        fmt::format("requires the extension '{}', which Lume does not support yet", known->name));
  }
}

std::vector<ExtensionUse> list_extensions(const JsonView& root, Notes& notes) {
  std::vector<ExtensionUse> uses;
  const auto use_of = [&](const std::string& name) -> ExtensionUse& {
    const auto it = std::find_if(uses.begin(), uses.end(),
                                 [&](const ExtensionUse& use) { return use.name == name; });
    return it != uses.end() ? *it : uses.emplace_back(describe(name));
  };
  for (const JsonView& name : root.items("extensionsUsed")) {
    use_of(name.text());
  }
  for (const JsonView& name : root.items("extensionsRequired")) {
    use_of(name.text()).required = true;
  }
  for (const ExtensionUse& use : uses) {
    if (use.support == Support::ignored) {
      notes.add("extension " + use.name,
                find_known(use.name) != nullptr ? "not supported yet; " + use.remark : use.remark);
    }
  }
  return uses;
}

}  // namespace lume::io::gltf
