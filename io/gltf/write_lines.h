// SPDX-License-Identifier: Apache-2.0
// Straight lines as a glTF file, to lay over a scene in any viewer.
#pragma once

#include "shading/color.h"

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace lume::io {

using LineSegment = std::array<geometry::Vec3, 2>;

/// Lines that are shown in one colour, under one name.
struct LineGroup {
  std::string name;
  shading::Color color{1.0f};  ///< linear Rec.709, 0 to 1; no light falls on it
  std::vector<LineSegment> segments;
};

/// Throws Error(input_output) if the name does not end in .gltf or .glb.
void check_lines_name(const std::filesystem::path& path);

/// Writes a glTF 2.0 file of its own, by its extension as JSON or GLB: a node and a mesh of lines
/// for each group that has any, below one node that moves them to `origin`. Ends of segments are
/// relative to that (metres) and must be finite. The file appears whole or not at all. Throws
/// Error(input_output).
void write_lines(const std::filesystem::path& path, std::span<const LineGroup> groups,
                 const geometry::DVec3& origin);

}  // namespace lume::io
