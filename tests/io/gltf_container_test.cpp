// SPDX-License-Identifier: Apache-2.0
// GLB containers, JSON text, URIs: what stands before the first property is read.
#include "io/error.h"
#include "io/gltf/load_gltf.h"
#include "io/gltf/resources.h"
#include "tests/support/gltf_file.h"
#include "tests/support/paths.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

namespace lume::io {
namespace {

namespace fs = std::filesystem;
using test::GltfFile;

/// The message of the error that loading gives, after its kind: "3 path: reason".
std::string error_of(const fs::path& path) {
  try {
    static_cast<void>(load_gltf(path));
  } catch (const Error& error) {
    return std::to_string(static_cast<int>(error.kind())) + " " + error.what();
  }
  return "no error";
}

std::string error_of_content(const std::string& content) {
  const tests::TemporaryFolder folder;
  test::write_bytes(folder / "file", content);
  return error_of(folder / "file");
}

std::string with_u32(std::string bytes, std::size_t offset, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes[offset + i] = static_cast<char>(value >> (8 * i));
  return bytes;
}

TEST(GltfContainer, Glb_IsKnownByItsContent) {
  const tests::TemporaryFolder folder;
  test::write_bytes(folder / "triangle.gltf", test::triangle_file().to_glb());
  EXPECT_EQ(load_gltf(folder / "triangle.gltf").scene.world.objects.size(), 1u);
}

TEST(GltfContainer, GlbLengthLies_AreSceneErrors) {
  const std::string glb = test::triangle_file().to_glb();
  for (const std::uint32_t lie : {0xFFFFFFFFu, 0x80000000u, 0x7FFFFFFFu}) {
    EXPECT_EQ(error_of_content(with_u32(glb, 8, lie)).front(), '3');   // whole file
    EXPECT_EQ(error_of_content(with_u32(glb, 12, lie)).front(), '3');  // JSON chunk
  }
  EXPECT_EQ(error_of_content(with_u32(glb, 4, 1)).front(), '3');   // version
  EXPECT_EQ(error_of_content(with_u32(glb, 8, 5)).front(), '3');   // shorter than a header
  EXPECT_EQ(error_of_content(with_u32(glb, 16, 0)).front(), '3');  // type of the first chunk
}

TEST(GltfContainer, GlbWithASecondChunkOfAType_IsSceneErrorAndAnUnknownOneIsNot) {
  const auto with_chunk = [](const std::string& type) {
    std::string glb = test::triangle_file().to_glb() + std::string("\4\0\0\0", 4) + type + "abcd";
    return with_u32(glb, 8, static_cast<std::uint32_t>(glb.size()));
  };
  EXPECT_EQ(error_of_content(with_chunk("JSON")).front(), '3');
  EXPECT_EQ(error_of_content(with_chunk(std::string("BIN\0", 4))).front(), '3');
  EXPECT_EQ(error_of_content(with_chunk("ACME")), "no error");
}

TEST(GltfContainer, GlbCutAnywhere_IsSceneError) {
  const std::string glb = test::triangle_file().to_glb();
  for (std::size_t size = 0; size < glb.size(); size += 7) {
    EXPECT_EQ(error_of_content(glb.substr(0, size)).front(), '3') << size;
  }
}

TEST(GltfContainer, GlbWithFlippedBytes_NeverCrashes) {
  const std::string glb = test::triangle_file().to_glb();
  test::Random random(7);
  const tests::TemporaryFolder folder;
  for (int i = 0; i < 500; ++i) {
    std::string broken = glb;
    for (int flips = 0; flips < 4; ++flips) {
      broken[random.below(static_cast<std::uint32_t>(glb.size()))] =
          static_cast<char>(random.below(256));
    }
    test::write_bytes(folder / "file", broken);
    EXPECT_NE(error_of(folder / "file"), "");
  }
}

TEST(GltfContainer, DeepJson_IsSceneError) {
  const std::string deep(100'000, '[');
  EXPECT_NE(error_of_content(deep).find("64"), std::string::npos);
  EXPECT_NE(error_of_content("{\"asset\":" + deep).find("64"), std::string::npos);
  EXPECT_NE(error_of_content("{\"extras\":\"" + deep + "\"}").find("asset"), std::string::npos);
}

TEST(GltfContainer, SyntaxError_NamesLineAndColumn) {
  EXPECT_NE(error_of_content("{\n  \"asset\": nonsense\n}").find("line 2"), std::string::npos);
  EXPECT_EQ(error_of_content("").front(), '3');
  EXPECT_EQ(error_of_content("[]").front(), '3');
  EXPECT_EQ(error_of_content("{\"asset\":{\"version\":\"2.0\"},\"scene\":1e999}").front(), '3');
  EXPECT_EQ(error_of_content("{\"asset\":\"\xFF\xFE\"}").front(), '3');
}

TEST(GltfContainer, WholeNumberWrittenAsFloat_IsAnInteger) {
  const tests::TemporaryFolder folder;
  GltfFile file = test::triangle_file();
  file.json["accessors"][0]["count"] = 3.0;
  file.json["nodes"][0]["mesh"] = 0.0;
  EXPECT_EQ(load_gltf(file.write(folder / "a.gltf")).scene.world.instances.size(), 1u);
}

TEST(GltfContainer, MissingFile_IsInputError) {
  const tests::TemporaryFolder folder;
  EXPECT_EQ(error_of(folder / "none.gltf"),
            "4 " + (folder / "none.gltf").string() + ": does not exist");
  EXPECT_EQ(error_of(folder.path()).front(), '4');
}

TEST(GltfContainer, HugeSparseFile_IsRefusedUnread) {
  const tests::TemporaryFolder folder;
  test::write_bytes(folder / "huge.glb", "glTF");
  fs::resize_file(folder / "huge.glb", std::uintmax_t{5} << 30);
  EXPECT_NE(error_of(folder / "huge.glb").find("4 GiB"), std::string::npos);
}

/// A folder with a secret beside the folder of the scene.
class GltfUri : public testing::Test {
 protected:
  GltfUri() {
    fs::create_directories(folder_ / "scene/parts");
    const GltfFile file = test::triangle_file();
    const std::string bytes(file.bytes.begin(), file.bytes.end());
    for (const char* name : {"secret.bin", "scene/data.bin", "scene/parts/with space.bin",
                             "scene/h\xC3\xA9ros.bin", "scene/100%.bin"}) {
      test::write_bytes(folder_ / name, bytes);
    }
    fs::create_symlink(folder_ / "secret.bin", folder_ / "scene/link.bin");
  }

  std::string load(const std::string& uri) {
    GltfFile file = test::triangle_file();
    file.json["buffers"] = {{{"byteLength", file.bytes.size()}, {"uri", uri}}};
    return error_of(file.write(folder_ / "scene/scene.gltf"));
  }

  tests::TemporaryFolder folder_;
};

TEST_F(GltfUri, FilesBesideTheScene_Load) {
  for (const char* uri :
       {"data.bin", "./data.bin", "parts/with%20space.bin", "parts/with space.bin",
        "parts/../data.bin", "h%C3%A9ros.bin", "h\xC3\xA9ros.bin", "100%.bin"}) {
    EXPECT_EQ(load(uri), "no error") << uri;
  }
}

TEST_F(GltfUri, WaysOutOfTheFolder_AreRefused) {
  for (const std::string& uri :
       {std::string("../secret.bin"), std::string("%2e%2e/secret.bin"),
        std::string("..%2Fsecret.bin"), std::string("parts/../../secret.bin"),
        std::string("link.bin"), (folder_ / "secret.bin").string(), std::string("/dev/zero"),
        "file://" + (folder_ / "secret.bin").string(), std::string("http://example.org/a.bin"),
        std::string("data.bin%00.png"), std::string("parts"), std::string(""),
        std::string("none.bin")}) {
    const std::string error = load(uri);
    EXPECT_EQ(error.front(), '3') << uri << ": " << error;
    EXPECT_NE(error.find("/buffers/0/uri"), std::string::npos) << uri << ": " << error;
  }
}

TEST(GltfBase64, RandomBytes_ComeBack) {
  test::Random random(3);
  for (std::size_t size = 0; size < 200; ++size) {
    std::vector<std::uint8_t> bytes(size);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
    const std::vector<std::byte> decoded = gltf::base64_decode(test::base64_encode(bytes));
    ASSERT_EQ(decoded.size(), size);
    for (std::size_t i = 0; i < size; ++i) {
      ASSERT_EQ(std::to_integer<std::uint8_t>(decoded[i]), bytes[i]);
    }
  }
}

TEST(GltfPercentDecode, KeepsWhatIsNoCode) {
  EXPECT_EQ(gltf::percent_decode("a%20b%C3%a9"), "a b\xC3\xA9");
  EXPECT_EQ(gltf::percent_decode("100%"), "100%");
  EXPECT_EQ(gltf::percent_decode("%4"), "%4");
  EXPECT_EQ(gltf::percent_decode("%zz+"), "%zz+");
}

}  // namespace
}  // namespace lume::io
