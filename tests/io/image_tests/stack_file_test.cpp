// SPDX-License-Identifier: Apache-2.0
// Stacks of images in one file.
#include "io/image_tests/stack_file.h"

#include "io/error.h"
#include "tests/support/paths.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace lume::io {
namespace {

ChannelImage random_image(const std::string& name, test::Random& random) {
  ChannelImage image;
  image.name = name;
  image.full_width = 20;
  image.full_height = 12;
  image.region = {3, 2, 7, 5};
  image.channels = {"R", "G", "B", "A", "depth.Z"};
  image.planes.assign(5, std::vector<float>(35));
  for (auto& plane : image.planes) {
    for (float& value : plane) value = random.uniform(-1e-3f, 1e6f);
  }
  return image;
}

TEST(StackFile, Parts_ComeBackToTheBit) {
  const tests::TemporaryFolder folder;
  test::Random random(1);
  std::vector<ChannelImage> images;
  for (int i = 0; i < 4; ++i) images.push_back(random_image("seed " + std::to_string(i), random));
  write_stack(folder / "s.exr", images);

  const ImageFile file = read_channels(folder / "s.exr");
  ASSERT_EQ(file.images.size(), 4u);
  const EstimateStack stack = stack_of(file);
  EXPECT_EQ(stack.shape.width, 7);
  EXPECT_EQ(stack.shape.height, 5);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(file.images[i].name, images[i].name);
    EXPECT_EQ(file.images[i].full_width, 20);
    EXPECT_EQ(file.images[i].region.x, 3);
    for (std::size_t channel = 0; channel < 5; ++channel) {
      // By name: a reader may sort them.
      for (std::size_t k = 0; k < 5; ++k) {
        if (stack.shape.channels[k] != images[i].channels[channel]) continue;
        EXPECT_EQ(stack.images[i][k], images[i].planes[channel]);
      }
    }
  }
}

TEST(StackFile, Mean_IsThatOfThePixels) {
  ImageFile file{"f", {}};
  test::Random random(2);
  for (int i = 0; i < 3; ++i) file.images.push_back(random_image("", random));
  const ChannelImage mean = mean_of(file);
  for (std::size_t pixel = 0; pixel < 35; ++pixel) {
    const double expected = (static_cast<double>(file.images[0].planes[4][pixel]) +
                             static_cast<double>(file.images[1].planes[4][pixel]) +
                             static_cast<double>(file.images[2].planes[4][pixel])) /
                            3.0;
    EXPECT_NEAR(mean.planes[4][pixel], expected, 1e-7 * std::abs(expected));
  }
}

TEST(StackFile, WhatIsNoStack_IsRefused) {
  test::Random random(3);
  ImageFile file{"f", {random_image("", random)}};
  EXPECT_THROW((void)stack_of(file), Error);
  file.images.push_back(random_image("", random));
  EXPECT_NO_THROW((void)stack_of(file));
  file.images[1].planes[2][7] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW((void)stack_of(file), Error);
  file.images[1] = random_image("", random);
  file.images[1].channels[0] = "X";
  EXPECT_THROW((void)stack_of(file), Error);
}

TEST(StackFile, FolderThatIsNotThere_IsAnError) {
  const tests::TemporaryFolder folder;
  test::Random random(4);
  EXPECT_THROW(write_stack(folder / "none/s.exr", {random_image("a", random)}), Error);
}

}  // namespace
}  // namespace lume::io
