// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace lume::cli {

/// " 42% [########............] 1 min 10 s, 1 min 37 s left" in at most `columns` characters.
[[nodiscard]] std::string format_progress_bar(double fraction, double elapsed_seconds,
                                              std::size_t columns);

/// Seconds until the end if the rest is as quick as what is done; NaN before anything is done.
[[nodiscard]] double seconds_left(double fraction, double elapsed_seconds);

/// Shows how far a render is: a bar that is redrawn in place on a terminal, a line for each tenth
/// of the work in a pipe. Not for several threads at once.
class Progress {
 public:
  enum class Style { none, lines, bar };

  /// The bar if `stream` is a terminal, else lines.
  [[nodiscard]] static Style style_for(std::FILE* stream);

  Progress(std::FILE* stream, Style style) : stream_(stream), style_(style) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { clear(); }

  void update(double fraction, double elapsed_seconds);
  /// Takes the bar off the screen.
  void clear();

 private:
  void draw_bar(double fraction, double elapsed_seconds);
  void print_line(double fraction, double elapsed_seconds);

  std::FILE* stream_;
  Style style_;
  double last_drawn_seconds_ = -1.0;
  int last_tenth_ = 0;
  bool bar_is_shown_ = false;
};

}  // namespace lume::cli
