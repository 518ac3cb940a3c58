// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace lume::cli {
namespace {

/// A stream whose text can be looked at.
class TextStream {
 public:
  TextStream() : stream_(std::tmpfile()) {}
  TextStream(const TextStream&) = delete;
  TextStream& operator=(const TextStream&) = delete;
  ~TextStream() { std::fclose(stream_); }
  [[nodiscard]] std::FILE* get() const { return stream_; }
  [[nodiscard]] std::string text() const {
    std::string text(static_cast<std::size_t>(std::ftell(stream_)), ' ');
    std::rewind(stream_);
    EXPECT_EQ(std::fread(text.data(), 1, text.size(), stream_), text.size());
    return text;
  }

 private:
  std::FILE* stream_;
};

TEST(Progress, Bar_ShowsPercentTimeAndRest) {
  EXPECT_EQ(format_progress_bar(0.25, 10.0, 40), " 25% [####.............] 10 s, 30 s left");
  EXPECT_EQ(format_progress_bar(1.0, 10.0, 34), "100% [#########] 10 s, 0.00 s left");
  EXPECT_EQ(format_progress_bar(0.5, 10.0, 24), " 50%  10 s, 10 s left");
}

TEST(Progress, Bar_NeverExceedsTheColumns) {
  for (std::size_t columns = 0; columns < 200; ++columns) {
    for (const double fraction : {-1.0, 0.0, 0.333, 1.0, 2.0, std::nan("")}) {
      EXPECT_LE(format_progress_bar(fraction, 12345.6, columns).size(), columns);
    }
  }
}

TEST(Progress, SecondsLeft_FollowsFromTheRate) {
  EXPECT_DOUBLE_EQ(seconds_left(0.2, 5.0), 20.0);
  EXPECT_DOUBLE_EQ(seconds_left(1.0, 5.0), 0.0);
  EXPECT_TRUE(std::isnan(seconds_left(0.0, 5.0)));
}

TEST(Progress, Lines_AreOneForEachTenth) {
  const TextStream stream;
  Progress progress(stream.get(), Progress::Style::lines);
  for (int i = 0; i <= 1000; ++i) progress.update(i / 1000.0, i * 0.01);
  const std::string text = stream.text();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
  EXPECT_EQ(text.substr(0, text.find('\n')), "lume: 10% after 1.0 s, 9.0 s left");
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
}

TEST(Progress, Bar_IsDrawnTenTimesASecondAndTakenAway) {
  const TextStream stream;
  {
    Progress progress(stream.get(), Progress::Style::bar);
    for (int i = 0; i <= 1000; ++i) progress.update(i / 1000.0, i * 0.001);
  }
  const std::string text = stream.text();
  const auto drawn =
      std::count(text.begin(), text.end(), '[') - std::count(text.begin(), text.end(), '\x1b');
  EXPECT_LE(drawn, 11);
  EXPECT_GE(drawn, 9);
  EXPECT_TRUE(text.ends_with("\r\x1b[K"));
}

TEST(Progress, None_IsSilent) {
  const TextStream stream;
  Progress progress(stream.get(), Progress::Style::none);
  progress.update(0.5, 1.0);
  progress.clear();
  EXPECT_EQ(stream.text(), "");
}

}  // namespace
}  // namespace lume::cli
