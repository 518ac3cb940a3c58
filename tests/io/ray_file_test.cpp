// SPDX-License-Identifier: Apache-2.0
// Ray files come back as they were written, and broken ones are refused in one line.
#include "io/ray_file.h"

#include "io/error.h"
#include "tests/support/cases.h"
#include "tests/support/paths.h"
#include "tests/support/random.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <fstream>
#include <limits>
#include <span>
#include <sstream>

namespace lume::io {
namespace {

using geometry::Ray;
using testing::HasSubstr;

std::vector<RayList> some_lists() {
  test::Random random(1);
  std::vector<RayList> lists = {
      {"primary", false, true, {}}, {"ao", true, false, {}}, {"none", false, false, {}}};
  for (std::size_t i = 0; i < 2; ++i) {
    for (int k = 0; k < 50; ++k) {
      Ray ray{
          .origin = random.cube(5.0f), .t_min = random.uniform(), .direction = random.cube(1.0f)};
      if (k % 2 == 0) ray.t_max = ray.t_min + random.uniform(0.0f, 9.0f);
      lists[i].rays.push_back(ray);
    }
  }
  return lists;
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

class RayFile : public testing::Test {
 protected:
  RayFile() {
    write_rays(path_, some_lists());
    bytes_ = bytes_of(path_);
  }
  [[nodiscard]] std::vector<RayList> decode(const std::string& bytes) const {
    return decode_rays(std::as_bytes(std::span(bytes)), path_);
  }
  void expect_refused(const std::string& bytes, const std::string& message) {
    try {
      (void)decode(bytes);
      ADD_FAILURE() << "accepted, expected: " << message;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input_output);
      EXPECT_THAT(error.what(), HasSubstr("a.rays"));
      EXPECT_THAT(error.what(), HasSubstr(message));
    }
  }
  /// The file with the four bytes at `at` replaced.
  [[nodiscard]] std::string with(std::size_t at, std::uint32_t value) const {
    std::string bytes = bytes_;
    std::memcpy(bytes.data() + at, &value, sizeof value);
    return bytes;
  }

  // Magic, version, number of kinds; then of the first kind: length, "primary", flags, count.
  static constexpr std::size_t k_version = 8, k_kinds = 12, k_length = 16, k_name = 20,
                               k_flags = 27, k_count = 31, k_ray = 39;
  tests::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "a.rays";
  std::string bytes_;
};

TEST_F(RayFile, RoundTrip_IsExact) {
  const std::vector<RayList> written = some_lists();
  const std::vector<RayList> read = read_rays(path_);
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].name, written[i].name);
    EXPECT_EQ(read[i].any_hit, written[i].any_hit);
    EXPECT_EQ(read[i].coherent, written[i].coherent);
    ASSERT_EQ(read[i].rays.size(), written[i].rays.size());
    if (read[i].rays.empty()) continue;
    EXPECT_EQ(
        std::memcmp(read[i].rays.data(), written[i].rays.data(), read[i].rays.size() * sizeof(Ray)),
        0);
  }
}

TEST_F(RayFile, Layout_IsAsDocumented) {
  EXPECT_EQ(bytes_.substr(0, 8), "LUMERAYS");
  EXPECT_EQ(bytes_.substr(k_name, 7), "primary");
  EXPECT_EQ(bytes_[k_flags], 2);
  EXPECT_EQ(bytes_[k_count], 50);
  float x = 0.0f;
  std::memcpy(&x, bytes_.data() + k_ray, sizeof x);
  EXPECT_EQ(x, some_lists()[0].rays[0].origin.x);
  EXPECT_EQ(bytes_.size(), 16 + 3 * 16 + std::strlen("primaryaonone") + 100 * 32);
}

TEST_F(RayFile, WhatIsWrong_IsSaid) {
  std::string bytes = bytes_;
  bytes[0] = 'l';
  expect_refused(bytes, "is not a ray file; expected it to begin with LUMERAYS");
  expect_refused("", "is not a ray file");
  expect_refused(with(k_version, 2), "version 2; this Lume reads version 1");
  expect_refused(with(k_kinds, 4000000000u), "expected at most 256");
  expect_refused(with(k_kinds, 2), "bytes too many");
  expect_refused(with(k_kinds, 4), "the file ends within a name's length");
  expect_refused(with(k_length, 0), "a name of 0 characters; expected 1 to 64");
  expect_refused(with(k_length, 65), "expected 1 to 64");
  expect_refused(with(k_name, 0x0a0a0a0au), "not printable ASCII");
  expect_refused(with(k_flags, 4), "unknown flags 0x4");
  expect_refused(with(k_count + 4, 0xffffffffu), "rays need 32 bytes each");
  expect_refused(bytes_ + "x", "1 bytes too many");
  EXPECT_THROW((void)read_rays(folder_ / "none.rays"), Error);
  EXPECT_THROW((void)read_rays(folder_.path()), Error);
}

TEST_F(RayFile, RaysThatAreNone_AreRefused) {
  const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const std::size_t field : {0u, 1u, 2u, 3u, 4u, 5u, 6u, 7u}) {
    expect_refused(with(k_ray + 32 + 4 * field, bits(nan)), "byte 71: ray 1 is not one");
    if (field < 7 && field != 3) {
      expect_refused(with(k_ray + 4 * field, bits(-infinity)), "byte 39: ray 0 is not one");
    }
  }
  expect_refused(with(k_ray + 12, bits(-1.0f)), "0 <= t_min <= t_max");
  expect_refused(with(k_ray + 28, bits(-1.0f)), "0 <= t_min <= t_max");
}

TEST_F(RayFile, EveryBeginning_IsRefused) {
  for (std::size_t size = 0; size < bytes_.size(); ++size) {
    EXPECT_THROW((void)decode(bytes_.substr(0, size)), Error) << size;
  }
}

TEST_F(RayFile, RandomBytes_AreReadOrRefused) {
  test::Random random(7);
  int refused = 0;
  for (int i = 0; i < test::cases(20000); ++i) {
    std::string bytes = bytes_;
    for (std::uint32_t k = random.below(4) + 1; k > 0; --k) {
      bytes[random.below(i % 2 == 0 ? 64 : static_cast<std::uint32_t>(bytes.size()))] =
          static_cast<char>(random.below(256));
    }
    try {
      for (const RayList& list : decode(bytes)) {
        for (const Ray& ray : list.rays) EXPECT_TRUE(is_traceable(ray));
      }
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, test::cases(5000));
}

TEST_F(RayFile, Writing_RefusesNamesThatReadingWould) {
  EXPECT_THROW(write_rays(path_, {{"", false, false, {}}}), Error);
  EXPECT_THROW(write_rays(path_, {{std::string(65, 'a'), false, false, {}}}), Error);
  EXPECT_THROW(write_rays(path_, {{"a\n", false, false, {}}}), Error);
  EXPECT_THROW(write_rays(folder_ / "none/a.rays", {{"a", false, false, {}}}), Error);
}

}  // namespace
}  // namespace lume::io
