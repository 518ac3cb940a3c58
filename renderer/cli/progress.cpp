// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/progress.h"

#include "renderer/cli/text.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <limits>

namespace lume::cli {
namespace {

std::size_t terminal_columns(std::FILE* stream) {
  winsize size{};
  const bool known = ioctl(fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

}  // namespace

double seconds_left(double fraction, double elapsed_seconds) {
  if (fraction <= 0.0) return std::numeric_limits<double>::quiet_NaN();
  return elapsed_seconds * (1.0 - fraction) / fraction;
}

std::string format_progress_bar(double fraction, double elapsed_seconds, std::size_t columns) {
  const double done = fraction > 0.0 ? std::min(fraction, 1.0) : 0.0;  // NaN is nothing done
  const std::string head = fmt::format("{:3}% ", static_cast<int>(done * 100.0));
  const std::string tail = fmt::format(" {}, {} left", format_duration(elapsed_seconds),
                                       format_duration(seconds_left(done, elapsed_seconds)));
  const std::size_t taken = head.size() + tail.size() + 2;
  if (columns < taken + 4) return (head + tail).substr(0, columns);
  const std::size_t cells = std::min<std::size_t>(columns - taken, 50);
  const auto full = static_cast<std::size_t>(done * static_cast<double>(cells));
  return fmt::format("{}[{}{}]{}", head, std::string(full, '#'), std::string(cells - full, '.'),
                     tail);
}

Progress::Style Progress::style_for(std::FILE* stream) {
  return isatty(fileno(stream)) == 1 ? Style::bar : Style::lines;
}

void Progress::update(double fraction, double elapsed_seconds) {
  if (style_ == Style::bar) draw_bar(fraction, elapsed_seconds);
  if (style_ == Style::lines) print_line(fraction, elapsed_seconds);
}

void Progress::draw_bar(double fraction, double elapsed_seconds) {
  constexpr double k_redraw_seconds = 0.1;
  const bool too_soon = elapsed_seconds - last_drawn_seconds_ < k_redraw_seconds;
  if (last_drawn_seconds_ >= 0.0 && too_soon) return;
  last_drawn_seconds_ = elapsed_seconds;
  // A line as wide as the terminal would wrap, and then \r could not take it back.
  const std::string bar =
      format_progress_bar(fraction, elapsed_seconds, terminal_columns(stream_) - 1);
  fmt::print(stream_, "\r{}\x1b[K", bar);
  std::fflush(stream_);
  bar_is_shown_ = true;
}

void Progress::print_line(double fraction, double elapsed_seconds) {
  const int tenth = static_cast<int>(fraction * 10.0 + 1e-9);
  if (tenth <= last_tenth_) return;
  last_tenth_ = tenth;
  const std::string rest =
      tenth < 10
          ? fmt::format(", {} left", format_duration(seconds_left(fraction, elapsed_seconds)))
          : "";
  fmt::print(stream_, "lume: {}% after {}{}\n", tenth * 10, format_duration(elapsed_seconds), rest);
  std::fflush(stream_);
}

void Progress::clear() {
  if (!bar_is_shown_) return;
  fmt::print(stream_, "\r\x1b[K");
  std::fflush(stream_);
  bar_is_shown_ = false;
}

}  // namespace lume::cli
