// SPDX-License-Identifier: Apache-2.0
// What the tests of writing pictures share.
#pragma once

#include "io/error.h"
#include "io/image_io.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <random>

namespace lume::tests {

/// Random colours, most of them partly transparent.
inline io::Picture make_picture(int width, int height) {
  io::Picture picture;
  picture.full_width = width;
  picture.full_height = height;
  picture.region = {0, 0, width, height};
  std::mt19937 random(6);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  for (int i = 0; i < width * height; ++i) {
    const float alpha = i % 5 == 0 ? 1.0f : uniform(random);
    picture.pixels.push_back(
        {uniform(random) * alpha, uniform(random) * alpha, uniform(random) * alpha, alpha});
  }
  return picture;
}

/// What the error says, or "no error".
inline std::string message_of(const std::filesystem::path& path, const io::Picture& picture,
                              const io::WriteOptions& options = {}) {
  try {
    write_picture(path, picture, options);
    return "no error";
  } catch (const io::Error& error) {
    EXPECT_EQ(error.kind(), io::ErrorKind::input_output);
    return error.what();
  }
}

/// A channel of an EXR by its name.
inline std::vector<float> read_channel(const std::filesystem::path& path, const std::string& name) {
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) return {};
  const int channel = input->spec().channelindex(name);
  std::vector<float> values(input->spec().image_pixels());
  EXPECT_GE(channel, 0) << name;
  EXPECT_TRUE(input->read_image(0, 0, channel, channel + 1, OIIO::TypeFloat, values.data()));
  return values;
}

}  // namespace lume::tests
