// SPDX-License-Identifier: Apache-2.0
// A stack of images that differ by their seeds, as the parts of one EXR file: the reference of a
// statistical case.
#pragma once

#include "io/compare/channel_image.h"
#include "io/compare/estimates.h"

#include <filesystem>
#include <vector>

namespace lume::io {

/// Writes the images as parts of 32-bit floats, by their names, which differ. The file appears
/// whole or not at all. Throws Error(input_output).
void write_stack(const std::filesystem::path& path, const std::vector<ChannelImage>& images);

/// The images of a file as the statistical test takes them. Throws Error(input_output) if they
/// differ in size or channels, if there are less than two, or if some value is not finite.
[[nodiscard]] EstimateStack stack_of(const ImageFile& file);

/// The mean of a file's images, to be looked at. They are as stack_of wants them.
[[nodiscard]] ChannelImage mean_of(const ImageFile& file);

}  // namespace lume::io
