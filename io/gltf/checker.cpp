// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/checker.h"

#include "io/gltf/unknown_properties.h"

#include <fmt/format.h>

#include <array>

namespace lume::io::gltf {
namespace {

constexpr const char* k_name = "LUME_texture_checker";
constexpr std::array<std::string_view, 2> k_properties = {"checks", "colors"};

/// More could not be told apart.
constexpr Range k_checks{.lower = 0.0, .upper = 1e6, .without_lower = true};

/// Linear RGBA; three numbers are opaque.
shading::Vec4 read_color(const JsonView& json) {
  const std::size_t size = json.items().size();
  if (size != 3 && size != 4) {
    json.fail(fmt::format("has {} numbers, expected 3 or 4", size));
  }
  std::vector<double> numbers = json.numbers(size, k_unit);
  numbers.resize(4, 1.0);
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

}  // namespace

std::optional<shading::Checker> find_checker(const JsonView& texture) {
  const std::optional<JsonView> json = texture.extension(k_name);
  if (!json) {
    return std::nullopt;
  }
  shading::Checker checker;
  if (const std::optional<JsonView> colors = json->find("colors")) {
    const std::vector<JsonView> items = colors->items();
    if (items.size() != checker.colors.size()) {
      colors->fail(fmt::format("has {} items, expected 2 colours", items.size()));
    }
    checker.colors = {read_color(items[0]), read_color(items[1])};
  }
  const std::vector<double> checks = json->numbers_or("checks", {2, 2}, k_checks);
  checker.checks = {checks[0], checks[1]};
  return checker;
}

void note_unknown_checker_properties(const JsonView& texture, const std::string& subject,
                                     Notes& notes) {
  if (const std::optional<JsonView> json = texture.extension(k_name)) {
    note_unknown_properties(*json, fmt::format("'{}'", k_name), k_properties, subject, notes);
  }
}

}  // namespace lume::io::gltf
