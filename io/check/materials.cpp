// SPDX-License-Identifier: Apache-2.0
#include "io/check/references.h"
#include "io/check/rules.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <type_traits>

namespace lume::io::check {
namespace {

using gltf::JsonView;
using shading::AlphaMode;
using shading::Image;
using shading::Material;

/// How many texels of an image let light through.
struct AlphaCount {
  std::size_t clear = 0;
  std::size_t solid = 0;
  std::size_t between = 0;

  [[nodiscard]] std::size_t total() const { return clear + solid + between; }
};

AlphaCount count_alpha(const Image& image) {
  AlphaCount count;
  std::visit(
      [&]<class T>(const std::vector<T>& texels) {
        constexpr T k_full = std::is_integral_v<T> ? std::numeric_limits<T>::max() : T(1);
        for (std::size_t i = 3; i < texels.size(); i += 4) {
          // Filtering and compression leave values near the ends.
          const double alpha = static_cast<double>(texels[i]) / static_cast<double>(k_full);
          std::size_t& kind = alpha < 0.02   ? count.clear
                              : alpha > 0.98 ? count.solid
                                             : count.between;
          ++kind;
        }
      },
      image.texels);
  return count;
}

/// What there is to say of one material: `json` as it is written, `material` as it is drawn.
class MaterialRules {
 public:
  MaterialRules(const Subject& subject, const JsonView& json, const Material& material,
                Findings& findings)
      : subject_(subject), json_(json), material_(material), findings_(findings) {}

  void check() {
    check_alpha();
    check_glass();
    check_emission();
  }

 private:
  void warn(const std::string& code, const std::string& member, const std::string& message,
            const std::string& advice) {
    findings_.add(Severity::warning, code, json_.pointer() + member, message, advice);
  }

  [[nodiscard]] const Image* base_color_image() const {
    const auto& scene = subject_.loaded.scene;
    if (!material_.base_color_texture) return nullptr;
    const shading::Texture& texture = scene.textures[material_.base_color_texture.texture];
    return texture.checker ? nullptr : &scene.images[texture.image];
  }

  void check_alpha() {
    const Image* image = base_color_image();
    const AlphaCount count = image != nullptr ? count_alpha(*image) : AlphaCount{};
    if (material_.alpha_mode == AlphaMode::blend) {
      check_blend(count);
    } else if (material_.alpha_mode == AlphaMode::opaque && count.clear * 20 > count.total()) {
      warn("alpha-ignored", "", "its texture has clear parts, but alphaMode OPAQUE shows them",
           "set alphaMode to MASK (or BLEND), or remove alpha from the texture");
    }
  }

  void check_blend(const AlphaCount& count) {
    if (material_.alpha < 1.0f) return;
    if (count.clear == 0 && count.between == 0) {
      findings_.add(Severity::advice, "blend-without-alpha", json_.pointer() + "/alphaMode",
                    "alphaMode is BLEND, but neither factor nor texture has any alpha",
                    "OPAQUE is faster, and in other viewers sorts right");
    } else if (count.clear > 0 && count.between * 20 < count.total()) {
      warn("blend-for-mask", "/alphaMode",
           "alphaMode is BLEND, but the texture's alpha is nearly everywhere 0 or 1",
           "MASK is faster, has sharp edges, and needs no sorting in other viewers");
    }
  }

  void check_glass() {
    const auto transmission = json_.extension("KHR_materials_transmission");
    const bool transmits =
        transmission && transmission->number_or("transmissionFactor", 0.0, gltf::k_unit) > 0.0;
    const auto volume = json_.extension("KHR_materials_volume");
    const bool solid =
        volume && volume->number_or("thicknessFactor", 0.0, gltf::k_not_negative) > 0.0;
    if (transmits && !solid) {
      const bool has_ior = json_.extension("KHR_materials_ior").has_value();
      findings_.add(
          has_ior || volume ? Severity::warning : Severity::advice, "thin-glass", json_.pointer(),
          "it transmits light but has no thickness: a window pane, which refracts nothing "
          "and absorbs nothing",
          "give it KHR_materials_volume with a thicknessFactor above 0 if it bounds a "
          "solid");
    }
    if (solid && !transmits && !json_.extension("KHR_materials_diffuse_transmission")) {
      warn("volume-unseen", "/extensions/KHR_materials_volume",
           "it has a volume, but lets no light in",
           "add KHR_materials_transmission with a transmissionFactor above 0");
    }
    if (transmits && material_.metallic >= 1.0f && !material_.metallic_roughness_texture) {
      warn("metal-transmits", "/pbrMetallicRoughness/metallicFactor",
           "it is all metal, which lets no light through whatever transmissionFactor says",
           "set metallicFactor to 0: absent, it is 1");
    }
    if (solid && material_.double_sided) {
      findings_.add(Severity::advice, "solid-double-sided", json_.pointer() + "/doubleSided",
                    "it bounds a solid, whose inside is seen anyway",
                    "leave doubleSided out: other viewers draw such glass twice");
    }
  }

  void check_emission() {
    const std::vector<double> factor = json_.numbers_or("emissiveFactor", {0, 0, 0}, gltf::k_unit);
    if (factor != std::vector<double>{0, 0, 0}) return;
    const bool has_strength = json_.extension("KHR_materials_emissive_strength").has_value();
    if (json_.has("emissiveTexture") || has_strength) {
      warn("glow-off",
           has_strength ? "/extensions/KHR_materials_emissive_strength" : "/emissiveTexture",
           "it is meant to glow, but emissiveFactor is absent and so black",
           "set emissiveFactor to [1, 1, 1]");
    }
  }

  const Subject& subject_;
  const JsonView& json_;
  const Material& material_;
  Findings& findings_;
};

/// An image cannot be colours (sRGB) and data (linear) at once.
void check_encodings(const Subject& subject, Findings& findings) {
  const gltf::Json& root = subject.document.json;
  if (!root.contains("materials") || !root.contains("textures")) return;
  const std::set<std::string> colors = {"baseColorTexture",
                                        "emissiveTexture",
                                        "diffuseTexture",
                                        "specularColorTexture",
                                        "sheenColorTexture",
                                        "specularGlossinessTexture",
                                        "diffuseTransmissionColorTexture"};
  std::map<std::size_t, bool> is_color;
  for (const gltf::Json& material : root["materials"]) {
    for (const TextureInfo& info : texture_infos(material)) {
      if (info.texture >= root["textures"].size()) continue;  // of an extension that is not read
      const gltf::Json& texture = root["textures"][info.texture];
      if (!texture.contains("source")) continue;
      const bool color = colors.contains(info.key);
      const auto image = texture["source"].get<std::size_t>();
      const auto [it, is_new] = is_color.try_emplace(image, color);
      if (!is_new && it->second != color) {
        findings.add(Severity::advice, "color-and-data", fmt::format("/images/{}", image),
                     "this image is read both as colours (sRGB) and as data (linear)",
                     "one of the two uses is probably a mistake");
      }
    }
  }
}

}  // namespace

void check_materials(const Subject& subject, Findings& findings) {
  const std::vector<JsonView> materials = subject.document.root().items("materials");
  for (std::size_t i = 0; i < materials.size(); ++i) {
    MaterialRules(subject, materials[i], subject.loaded.scene.materials[i], findings).check();
  }
  check_encodings(subject, findings);
}

}  // namespace lume::io::check
