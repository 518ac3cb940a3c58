// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/argument_parsing.h"

#include "renderer/cli/exit_codes.h"
#include "renderer/cli/suggest.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace lume::cli {
namespace {

template <class T>
std::optional<T> parse_number(std::string_view text) {
  // A leading plus is natural ("--exposure +1"), but from_chars refuses it.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  std::size_t end = 0;
  while ((end = text.find(separator)) != std::string_view::npos) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

/// Turns a parser that throws into what CLI11 wants: a message, empty when all is well.
CLI::Validator make_check(std::function<void(const std::string&)> parse) {
  auto check = [parse = std::move(parse)](std::string& text) -> std::string {
    try {
      parse(text);
    } catch (const UsageError& error) {
      return error.what();
    }
    return {};
  };
  return {std::move(check), ""};
}

}  // namespace

std::uint64_t parse_whole(std::string_view text, std::uint64_t low, std::uint64_t high) {
  const auto value = parse_number<std::uint64_t>(text);
  if (!value || *value < low || *value > high) {
    throw UsageError(
        fmt::format("expected a whole number from {} to {}, got '{}'", low, high, printable(text)));
  }
  return *value;
}

double parse_real(std::string_view text, double low, double high) {
  const auto value = parse_number<double>(text);
  // Written so that NaN fails.
  if (!value || !(*value >= low && *value <= high)) {
    throw UsageError(
        fmt::format("expected a number from {:g} to {:g}, got '{}'", low, high, printable(text)));
  }
  return *value;
}

geometry::DVec3 parse_triple(std::string_view text, double limit) {
  const std::vector<std::string_view> parts = split(text, ',');
  if (parts.size() != 3) {
    throw UsageError(
        fmt::format("expected three numbers between commas, got '{}'", printable(text)));
  }
  return {parse_real(parts[0], -limit, limit), parse_real(parts[1], -limit, limit),
          parse_real(parts[2], -limit, limit)};
}

shading::PixelRegion parse_crop(std::string_view text) {
  const std::size_t times = text.find('x');
  const std::size_t plus = text.find('+');
  const std::size_t second_plus = plus == text.npos ? text.npos : text.find('+', plus + 1);
  const bool shaped = times != text.npos && second_plus != text.npos && times < plus;
  const auto number = [&](std::size_t begin, std::size_t end) -> std::optional<std::uint16_t> {
    const std::string_view digits = text.substr(begin, end - begin);
    return digits.starts_with('+') ? std::nullopt : parse_number<std::uint16_t>(digits);
  };
  if (shaped) {
    const auto width = number(0, times);
    const auto height = number(times + 1, plus);
    const auto x = number(plus + 1, second_plus);
    const auto y = number(second_plus + 1, text.size());
    if (width && height && x && y && *width > 0 && *height > 0) return {*x, *y, *width, *height};
  }
  throw UsageError(fmt::format(
      "expected WIDTHxHEIGHT+X+Y in pixels, such as 320x240+100+50, got '{}'", printable(text)));
}

std::vector<std::string> parse_names(std::string_view text, std::string_view what,
                                     const std::vector<std::string>& known) {
  std::vector<std::string> names;
  for (const std::string_view part : split(text, ',')) {
    if (part == "all") return known;
    if (std::find(known.begin(), known.end(), part) == known.end()) {
      throw UsageError(unknown_name(what, part, known));
    }
    if (std::find(names.begin(), names.end(), part) == names.end()) names.emplace_back(part);
  }
  return names;
}

CLI::Validator whole_between(std::uint64_t low, std::uint64_t high) {
  return make_check([=](const std::string& text) { (void)parse_whole(text, low, high); });
}

CLI::Validator real_between(double low, double high) {
  return make_check([=](const std::string& text) { (void)parse_real(text, low, high); });
}

CLI::Validator file_name() {
  return make_check([](const std::string& text) {
    if (!text.empty() && text[0] != '-') return;
    throw UsageError(fmt::format("expected a file's name, got '{}'", printable(text)));
  });
}

CLI::Validator one_of(std::string what, std::vector<std::string> names) {
  return make_check([what = std::move(what), names = std::move(names)](const std::string& text) {
    if (std::find(names.begin(), names.end(), text) != names.end()) return;
    throw UsageError(unknown_name(what, text, names));
  });
}

CLI::Validator name_or_file(std::string what, std::vector<std::string> names) {
  return make_check([what = std::move(what), names = std::move(names)](const std::string& text) {
    if (text.find('/') != std::string::npos) return;
    if (std::find(names.begin(), names.end(), text) != names.end()) return;
    throw UsageError(unknown_name(what, text, names));
  });
}

}  // namespace lume::cli
