// SPDX-License-Identifier: Apache-2.0
#include "tests/images/exr_file.h"

#include "io/image_io.h"

#include <OpenImageIO/imageio.h>

#include <stdexcept>

namespace lume::tests {

ExrFile read_exr(const std::filesystem::path& path) {
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) throw std::runtime_error(path.string() + ": " + OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  ExrFile file{spec.width, spec.height, spec.channelnames, {}};
  file.values.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, file.values.data())) {
    throw std::runtime_error(path.string() + ": " + input->geterror());
  }
  return file;
}

void write_exr(const std::filesystem::path& path, const renderer::Film& film) {
  io::Picture picture;
  picture.full_width = film.region.width;
  picture.full_height = film.region.height;
  picture.region = film.region;
  picture.pixels = film.pixels;
  for (const renderer::Film::Layer& layer : film.layers) {
    const renderer::AovInfo& info = renderer::aov_infos()[static_cast<std::size_t>(layer.aov)];
    picture.layers.push_back({{info.channels.begin(), info.channels.end()},
                              layer.values,
                              info.source == renderer::AovSource::center});
  }
  io::write_picture(path, picture, {});
}

}  // namespace lume::tests
