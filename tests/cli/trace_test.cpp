// SPDX-License-Identifier: Apache-2.0
// `lume trace` from the outside, and the rays that it writes as lines.
#include "io/gltf/load_gltf.h"
#include "renderer/cli/svg_writer.h"
#include "renderer/cli/trace_report.h"
#include "renderer/cli/trace_terms.h"
#include "tests/cli/run_lume.h"
#include "tests/support/gltf_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>

namespace lume::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using Arguments = std::vector<std::string>;

class TraceCommand : public testing::Test {
 protected:
  /// A pixel in which glass is seen.
  Outcome trace(Arguments more) {
    const auto scene = tests::source_dir() / "assets/scenes/whitted.gltf";
    Arguments arguments = {"trace",   scene.string(), "--width",  "64",
                           "--pixel", "26,24",        "--height", "48"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_lume(folder_, arguments);
  }

  void expect_error(const Arguments& more, int exit_code, const std::string& message) {
    const Outcome outcome = trace(more);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, HasSubstr("lume: error: "));
    EXPECT_THAT(outcome.err, HasSubstr(message));
  }

  tests::TemporaryFolder folder_;
};

TEST_F(TraceCommand, Text_TellsEveryTerm) {
  const Outcome outcome = trace({"-q"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const char* part : {"pixel   26,24: ", "camera ray, depth 0: ", "reflection ray, depth 1: ",
                           "refraction ray, depth 1: ", "from inside", "L_a", "n.l", "├ ", "└ ",
                           "│ ", "the same as the pixel, to the last bit"}) {
    EXPECT_THAT(outcome.out, HasSubstr(part));
  }
}

TEST_F(TraceCommand, Raycast_HasOneRayAndItsShadows) {
  const Outcome outcome = trace({"--integrator", "raycast"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("0 reflection, 0 refraction"));
  EXPECT_THAT(outcome.out, HasSubstr("shadow ray to"));
  EXPECT_THAT(outcome.out, HasSubstr("to the last bit"));
}

TEST_F(TraceCommand, Samples_AreChosenByNumber) {
  const Outcome outcome = trace({"--spp", "4", "--sample", "3"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Sample 3 of 4"));
  EXPECT_THAT(outcome.out, HasSubstr("The mean of all 4 samples is"));
}

TEST_F(TraceCommand, JsonOnStdout_TakesThePlaceOfTheText) {
  const Outcome outcome = trace({"--json", "-", "--spp", "2"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json tree = json::parse(outcome.out);
  EXPECT_EQ(tree["pixel"], json({26, 24}));
  EXPECT_EQ(tree["settings"]["integrator"], "whitted");
  EXPECT_EQ(tree["samples"].size(), 2u);
  EXPECT_EQ(tree["ray_counts"]["camera"], 2);
}

TEST_F(TraceCommand, Files_AreAllWritten) {
  const Outcome outcome = trace({"--json", "t.json", "--svg", "t.svg", "--gltf", "t.glb"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("to the last bit"));
  EXPECT_TRUE(json::accept(read_text(folder_ / "t.json")));
  const std::string svg = read_text(folder_ / "t.svg");
  EXPECT_THAT(svg, HasSubstr("glass sphere"));
  EXPECT_THAT(svg, HasSubstr(">R × "));
  EXPECT_THAT(svg, HasSubstr(">T × "));
  EXPECT_THAT(svg, HasSubstr("stroke-dasharray"));
  const Outcome info = run_lume(folder_, {"info", "t.glb"});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr("lines are not drawn"));
}

TEST_F(TraceCommand, Mistakes_AreOneLine) {
  expect_error({"--pixel", "64,0"}, 2, "--pixel: 64,0 lies outside the picture of 64x48 pixels");
  expect_error({"--pixel", "0,48"}, 2, "outside");
  expect_error({"--pixel", "7"}, 2, "expected X,Y");
  expect_error({"--pixel", "-1,2"}, 2, "--pixel");
  expect_error({"--sample", "1"}, 2, "--sample: 1 is not one of 1 sample");
  expect_error({"--spp", "5000"}, 2, "4096");
  expect_error({"--svg", "a", "--json", "./a"}, 2, "the same file");
  expect_error({"--gltf", "rays.obj"}, 4, "expected .gltf or .glb");
  expect_error({"--svg", "none/a.svg"}, 4, "folder");
  const Outcome none = run_lume(folder_, {"trace"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("no scene given"));
  const Outcome no_pixel = run_lume(folder_, {"trace", "a.gltf"});
  EXPECT_EQ(no_pixel.exit_code, 2);
  EXPECT_THAT(no_pixel.err, HasSubstr("no pixel given"));
}

TEST_F(TraceCommand, NamesFromTheFile_AreHarmless) {
  test::GltfFile file = test::triangle_file();
  file.json["nodes"][0]["name"] = "<b>&\"\x1b[31m";
  file.json["nodes"][1]["translation"] = {0.4, 0.4, 2.0};
  file.write(folder_ / "a.gltf");
  const Outcome outcome = run_lume(folder_, {"trace", "a.gltf", "--width", "8", "--height", "8",
                                             "--pixel", "4,4", "--svg", "a.svg"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find('\x1b'), std::string::npos);
  EXPECT_THAT(read_text(folder_ / "a.svg"), HasSubstr(">&lt;b&gt;&amp;&quot;?[31m<"));
}

TEST(SvgText, WhatXmlForbids_IsReplaced) {
  EXPECT_EQ(xml_text("a\x01 b\xff c\xEF\xBF\xBE"), "a  b\xEF\xBF\xBD c?");
  EXPECT_EQ(shorten("Kugel äöü", 8), "Kugel ä…");
  EXPECT_EQ(shorten("Kugel", 5), "Kugel");
  EXPECT_EQ(count_characters("äöü"), 3u);
}

/// The ends of all lines of a group, as a viewer reads them.
std::vector<geometry::Vec3> read_lines(const json& gltf, const std::string& binary,
                                       const std::string& group) {
  for (const json& node : gltf.at("nodes")) {
    if (node.at("name") != group) continue;
    const json& primitive = gltf["meshes"].at(node.at("mesh").get<std::size_t>())["primitives"][0];
    EXPECT_EQ(primitive.at("mode"), 1);
    const json& accessor =
        gltf["accessors"].at(primitive["attributes"]["POSITION"].get<std::size_t>());
    const json& view = gltf["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
    std::vector<geometry::Vec3> ends(accessor["count"].get<std::size_t>());
    EXPECT_EQ(view["byteLength"], ends.size() * sizeof(geometry::Vec3));
    std::memcpy(ends.data(), binary.data() + view["byteOffset"].get<std::size_t>(),
                ends.size() * sizeof(geometry::Vec3));
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax_element(
          ends.begin(), ends.end(), [i](const auto& a, const auto& b) { return a[i] < b[i]; });
      EXPECT_EQ(accessor["min"][static_cast<std::size_t>(i)].get<double>(), (*low)[i]);
      EXPECT_EQ(accessor["max"][static_cast<std::size_t>(i)].get<double>(), (*high)[i]);
    }
    return ends;
  }
  return {};
}

class TraceLines : public testing::Test {
 protected:
  TraceLines() : loaded_(io::load_gltf(tests::source_dir() / "assets/scenes/whitted.gltf")) {
    const renderer::PreparedScene prepared(loaded_.scene, "embree");
    const auto integrator = renderer::make_integrator("whitted", prepared, {});
    const renderer::PixelSettings settings{64, 48, 1, 0, renderer::PixelFilter()};
    const geometry::Camera& camera = loaded_.scene.cameras.at(0);
    trace_ = trace_pixel(camera, *integrator, settings, 26, 24);
  }

  [[nodiscard]] TraceReport report() const {
    return {options_, loaded_.scene, {64, 48}, "", "", trace_};
  }

  tests::TemporaryFolder folder_;
  io::LoadedScene loaded_;
  TraceOptions options_;
  renderer::PixelTrace trace_;
};

TEST_F(TraceLines, Glb_HoldsTheRays) {
  const geometry::DVec3 origin(1e7, -2.0, 0.125);
  io::write_lines(folder_ / "a.glb", trace_to_lines(report()), origin);
  const std::string file = read_text(folder_ / "a.glb");
  std::uint32_t length = 0;
  std::memcpy(&length, file.data() + 8, 4);
  EXPECT_EQ(length, file.size());
  std::memcpy(&length, file.data() + 12, 4);
  const json gltf = json::parse(file.substr(20, length));
  const std::string binary = file.substr(20 + length + 8);
  EXPECT_EQ(gltf["nodes"][0]["translation"], json({1e7, -2.0, 0.125}));

  std::array<std::size_t, 5> seen{};
  std::array<std::vector<geometry::Vec3>, 5> lines;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i] = read_lines(gltf, binary, std::string(k_ray_looks[i].name));
  }
  const auto expect_next = [&](std::size_t kind, const geometry::Vec3& from) {
    ASSERT_LT(2 * seen[kind] + 1, lines[kind].size());
    EXPECT_EQ(lines[kind][2 * seen[kind]], from);
  };
  for (const renderer::RayNote& ray : trace_.samples[0].rays) {
    const auto kind = static_cast<std::size_t>(ray.kind);
    expect_next(kind, ray.ray.origin);
    const geometry::Vec3 end = lines[kind][2 * seen[kind]++ + 1];
    if (!ray.backdrop && !ray.surfaces.empty()) {
      EXPECT_EQ(end, ray.surfaces.back().point.position);
    } else {
      EXPECT_GT(distance(end, ray.ray.origin), 10.0f);
      EXPECT_GT(dot(normalize(end - ray.ray.origin), ray.ray.direction), 0.9999f);
    }
  }
  for (const renderer::LightNote& light : trace_.samples[0].lights) {
    const std::size_t kind = light.transmittance == shading::Color(0.0f) ? 4 : 3;
    expect_next(kind, light.ray.origin);
    EXPECT_EQ(lines[kind][2 * seen[kind]++ + 1], light.ray.origin + light.ray.direction);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(lines[i].size(), 2 * seen[i]);
  EXPECT_GT(seen[1], 0u);
  EXPECT_GT(seen[2], 0u);
  EXPECT_GT(seen[3], 0u);
}

TEST_F(TraceLines, Text_HoldsTheSameAsGlb) {
  const std::vector<io::LineGroup> lines = trace_to_lines(report());
  io::write_lines(folder_ / "a.glb", lines, {});
  io::write_lines(folder_ / "a.gltf", lines, {});
  const std::string glb = read_text(folder_ / "a.glb");
  const json gltf = json::parse(read_text(folder_ / "a.gltf"));
  const std::size_t size = gltf["buffers"][0]["byteLength"];
  const std::string binary = glb.substr(glb.size() - size);
  EXPECT_EQ(gltf["buffers"][0]["uri"],
            "data:application/octet-stream;base64," +
                test::base64_encode(std::vector<std::uint8_t>(binary.begin(), binary.end())));
  EXPECT_EQ(io::load_gltf(folder_ / "a.gltf").notes.size(), 1u);
}

TEST_F(TraceLines, NoRays_StillGiveAFile) {
  io::write_lines(folder_ / "a.glb", {}, {});
  EXPECT_NO_THROW((void)io::load_gltf(folder_ / "a.glb"));
}

}  // namespace
}  // namespace lume::cli
