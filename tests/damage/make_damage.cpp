// SPDX-License-Identifier: Apache-2.0
// Does to images, and to a scene, what goes wrong in renderers and around them, so that
// tests/damage/run can ask which comparison finds what. The same input gives the same output.
//
//   make_damage images FOLDER FILE.exr...       every file as FOLDER/<damage>/FILE.exr
//   make_damage without NAME SCENE.gltf OUTPUT  the scene, but for the object of that name
#include "io/compare/channel_image.h"

#include <OpenImageIO/imageio.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using lume::io::ChannelImage;

constexpr std::size_t k_colors = 3;  // R, G and B come first in a file; alpha is left alone

/// Where a single pixel is damaged: on the back wall of the Cornell box, in plain view.
std::size_t damaged_pixel(const ChannelImage& image) {
  const int x = image.region.width / 2;
  const int y = image.region.height / 3;
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.region.width) +
         static_cast<std::size_t>(x);
}

template <class Value>
void change_colors(ChannelImage& image, const Value& value) {
  for (std::size_t i = 0; i < k_colors; ++i) {
    for (float& v : image.planes[i]) v = value(v);
  }
}

void set_pixel(ChannelImage& image, float value) {
  for (std::size_t i = 0; i < k_colors; ++i) image.planes[i][damaged_pixel(image)] = value;
}

/// Takes `width` columns from column `first` on; what lies left of the image is its first column.
void take_columns(ChannelImage& image, int first, int width) {
  const auto old_width = static_cast<std::size_t>(image.region.width);
  for (std::vector<float>& plane : image.planes) {
    std::vector<float> taken;
    taken.reserve(plane.size());
    for (std::size_t row = 0; row < plane.size(); row += old_width) {
      for (int x = 0; x < width; ++x) {
        taken.push_back(plane[row + static_cast<std::size_t>(std::max(first + x, 0))]);
      }
    }
    plane = std::move(taken);
  }
  image.region.width = width;
}

/// IEC 61966-2-1, inverse of shading::srgb_to_linear; above 1 it goes on by the same power.
float encode_srgb(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

void gamma(ChannelImage& image) {
  change_colors(image, [](float v) { return std::pow(v, 1.0f / 1.01f); });
}

void energy_loss(ChannelImage& image) {
  change_colors(image, [](float v) { return 0.98f * v; });
}

void shift(ChannelImage& image) { take_columns(image, -1, image.region.width); }

void crop(ChannelImage& image) {
  constexpr int k_columns = 8;
  take_columns(image, 0, image.region.width - k_columns);
  image.full_width = image.region.width;
}

void swap_channels(ChannelImage& image) { std::swap(image.planes[0], image.planes[2]); }

void wrong_color_space(ChannelImage& image) { change_colors(image, encode_srgb); }

void not_a_number(ChannelImage& image) {
  set_pixel(image, std::numeric_limits<float>::quiet_NaN());
}

void firefly(ChannelImage& image) { set_pixel(image, 100.0f); }

struct Damage {
  const char* name;
  void (*apply)(ChannelImage&);
  bool only_first;  ///< of the files: what befalls a single sample befalls a single seed
};

constexpr Damage k_damages[] = {
    {"nan", not_a_number, true},    {"shift", shift, false},
    {"gamma", gamma, false},        {"energy", energy_loss, false},
    {"firefly", firefly, true},     {"crop", crop, false},
    {"swap", swap_channels, false}, {"space", wrong_color_space, false},
};

void write(const std::filesystem::path& path, const ChannelImage& image) {
  OIIO::ImageSpec spec(image.region.width, image.region.height,
                       static_cast<int>(image.channels.size()), OIIO::TypeDesc::FLOAT);
  spec.channelnames = image.channels;
  spec.full_width = image.full_width;
  spec.full_height = image.full_height;
  std::vector<float> values;
  values.reserve(image.planes.size() * image.planes[0].size());
  for (std::size_t pixel = 0; pixel < image.planes[0].size(); ++pixel) {
    for (const std::vector<float>& plane : image.planes) values.push_back(plane[pixel]);
  }
  const auto output = OIIO::ImageOutput::create(path.string());
  if (!output || !output->open(path.string(), spec) ||
      !output->write_image(OIIO::TypeDesc::FLOAT, values.data()) || !output->close()) {
    throw std::runtime_error(path.string() + ": cannot be written");
  }
}

void damage_images(const std::filesystem::path& folder, std::span<char* const> files) {
  for (const Damage& damage : k_damages) {
    std::filesystem::create_directories(folder / damage.name);
    for (std::size_t i = 0; i < files.size(); ++i) {
      ChannelImage image = lume::io::read_channels(files[i]).images.at(0);
      if (image.channels.size() < k_colors || image.channels[0] != "R") {
        throw std::runtime_error(std::string(files[i]) + ": its first channels are not R, G, B");
      }
      if (i == 0 || !damage.only_first) damage.apply(image);
      write(folder / damage.name / std::filesystem::path(files[i]).filename(), image);
    }
  }
}

/// The node stays where it is, so that all others keep their numbers; no scene shows it any more.
void remove_object(const std::string& name, const char* scene, const char* output) {
  auto document = nlohmann::json::parse(std::ifstream(scene));
  const auto& nodes = document.at("nodes");
  const auto found = std::find_if(nodes.begin(), nodes.end(), [&](const nlohmann::json& node) {
    return node.value("name", "") == name;
  });
  if (found == nodes.end()) throw std::runtime_error(std::string(scene) + ": has no " + name);
  const auto index = found - nodes.begin();
  for (nlohmann::json& shown : document.at("scenes")) {
    auto& list = shown.at("nodes");
    list.erase(std::remove(list.begin(), list.end(), index), list.end());
  }
  std::ofstream(output) << document;
}

}  // namespace

int main(int count, char** arguments) {
  const std::span<char* const> all(arguments, static_cast<std::size_t>(count));
  const std::string task = count > 1 ? arguments[1] : "";
  try {
    if (task == "images" && count > 3) {
      damage_images(arguments[2], all.subspan(3));
      return 0;
    }
    if (task == "without" && count == 5) {
      remove_object(arguments[2], arguments[3], arguments[4]);
      return 0;
    }
  } catch (const std::exception& error) {
    std::cerr << "make_damage: " << error.what() << '\n';
    return 1;
  }
  std::cerr << "usage: make_damage images FOLDER FILE...\n"
               "       make_damage without NAME SCENE OUTPUT\n";
  return 2;
}
