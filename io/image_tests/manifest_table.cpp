// SPDX-License-Identifier: Apache-2.0
#include "io/image_tests/manifest_table.h"

#include "io/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lume::io {
namespace {

std::string_view kind_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return node.is_array_of_tables() ? "an array of tables" : "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "a whole number";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

std::string shown(const toml::node& node) {
  if (const auto text = node.value<std::string>(); node.is_string()) return "'" + *text + "'";
  if (node.is_number()) return fmt::format("{}", node.value_or(0.0));
  return std::string(kind_name(node));
}

}  // namespace

ManifestTable::ManifestTable(const std::filesystem::path& file, const toml::table& table,
                             std::string where, const std::vector<std::string>& keys)
    : file_(file), table_(table), where_(std::move(where)) {
  for (const auto& [key, value] : table_) {
    const std::string name(key.str());
    if (std::find(keys.begin(), keys.end(), name) != keys.end()) continue;
    fail(static_cast<int>(key.source().begin.line),
         fmt::format("unknown key '{}'{}", name, list_names(name, keys)));
  }
}

int ManifestTable::line(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return node != nullptr ? line_of(*node) : line();
}

void ManifestTable::fail(int line, const std::string& message) const {
  throw ManifestError(file_, line, where_ + ": " + message);
}

void ManifestTable::fail_value(std::string_view key, const std::string& expected) const {
  const toml::node* node = table_.get(key);
  fail(line(key), fmt::format("{}: expected {}, found {}", key, expected,
                              node != nullptr ? shown(*node) : "nothing"));
}

std::optional<std::string> ManifestTable::text(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_string()) fail_value(key, "a string");
  auto text = node->value<std::string>();
  if (text->empty()) fail_value(key, "a string that is not empty");
  return text;
}

std::optional<double> ManifestTable::number(std::string_view key, double low, double high) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  const double value = node->is_number() ? node->value_or(0.0) : std::nan("");
  if (!(value >= low && value <= high)) {
    fail_value(key, std::isinf(high) ? fmt::format("a number of at least {}", low)
                                     : fmt::format("a number from {} to {}", low, high));
  }
  if (std::isinf(value)) fail_value(key, "a finite number");
  return value;
}

std::optional<int> ManifestTable::whole(std::string_view key, int low, int high) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  const std::int64_t value = node->is_integer() ? node->value_or<std::int64_t>(0) : low - 1;
  if (value < low || value > high) {
    fail_value(key, fmt::format("a whole number from {} to {}", low, high));
  }
  return static_cast<int>(value);
}

std::vector<std::string> ManifestTable::texts(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return {};
  const toml::array* array = node->as_array();
  if (array == nullptr) fail_value(key, "an array of strings");
  std::vector<std::string> texts;
  texts.reserve(array->size());
  for (const toml::node& element : *array) {
    if (!element.is_string()) {
      fail(line_of(element), fmt::format("{}: expected strings, found {}", key, shown(element)));
    }
    texts.push_back(element.value_or(std::string()));
  }
  if (texts.empty()) fail_value(key, "at least one string");
  return texts;
}

std::vector<std::string> ManifestTable::text_or_texts(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr || node->is_array()) return texts(key);
  if (!node->is_string()) fail_value(key, "a string or an array of strings");
  return {*text(key)};
}

const toml::table* ManifestTable::table(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node != nullptr && !node->is_table()) fail_value(key, "a table");
  return node != nullptr ? node->as_table() : nullptr;
}

std::vector<const toml::table*> ManifestTable::tables(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return {};
  const bool is_tables = node->is_array_of_tables();
  if (!is_tables) fail_value(key, fmt::format("tables, each under a line [[{}]]", key));
  std::vector<const toml::table*> tables;
  tables.reserve(node->as_array()->size());
  for (const toml::node& element : *node->as_array()) tables.push_back(element.as_table());
  return tables;
}

}  // namespace lume::io
