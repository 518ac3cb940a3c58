// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/load_gltf.h"

#include "io/gltf/animations.h"
#include "io/gltf/document.h"
#include "io/gltf/extensions.h"
#include "io/gltf/materials.h"
#include "io/gltf/nodes.h"
#include "io/gltf/notes.h"
#include "io/gltf/phong.h"
#include "io/gltf/scene_builder.h"
#include "io/gltf/textures.h"

#include <fmt/format.h>

namespace lume::io {
namespace {

void play(gltf::Document& document, const LoadOptions& options, gltf::Notes& notes) {
  if (!options.time) {
    return;
  }
  if (const auto animation = gltf::choose_animation(document, options.animation)) {
    gltf::apply_animation(document, *animation, *options.time, notes);
  }
}

void note_unused_parts(const gltf::JsonView& root, const LoadOptions& options, gltf::Notes& notes) {
  if (options.time) {
    return;
  }
  if (const std::size_t count = root.items("animations").size(); count > 0) {
    notes.add("animations",
              fmt::format("{} not played without a time; nodes stay where they are", count));
  }
}

}  // namespace

LoadedScene load_gltf(const std::filesystem::path& path, const LoadOptions& options) {
  gltf::Document document = gltf::open_document(path);
  const gltf::JsonView root = document.root();
  gltf::Notes notes;
  play(document, options, notes);
  LoadedScene result;
  result.extensions = gltf::list_extensions(root, notes);
  result.generator = document.model.asset.generator;
  result.copyright = document.model.asset.copyright;
  result.scene_names = gltf::scene_names(document);
  result.scene_index = gltf::choose_scene(document, options.scene);

  gltf::read_phong_scenes(root, result.scene_index, result.scene, notes);
  gltf::TextureTable textures(document, notes);
  result.scene.materials = gltf::read_materials(root, textures, notes);
  const auto nodes = gltf::flatten(document, gltf::root_nodes(document, result.scene_index));
  gltf::build_scene(document, nodes, options.tessellated, result.scene, notes);
  result.scene.textures = textures.textures();
  result.scene.images = textures.load_images(options.decode_images);

  note_unused_parts(root, options, notes);
  result.notes = notes.lines();
  return result;
}

}  // namespace lume::io
