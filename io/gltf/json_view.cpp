// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/json_view.h"

#include "io/error.h"

#include <fmt/format.h>

namespace lume::io::gltf {
namespace {

/// A member's name inside a JSON pointer (RFC 6901, section 3).
std::string escape(std::string_view key) {
  std::string result;
  for (const char c : key) {
    if (c == '~') {
      result += "~0";
    } else if (c == '/') {
      result += "~1";
    } else {
      result += c;
    }
  }
  return result;
}

/// A value short enough to be shown in a message.
std::string shown(const Json& value) {
  if (value.is_object()) {
    return "an object";
  }
  if (value.is_array()) {
    return fmt::format("an array of {}", value.size());
  }
  const std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  return text.size() <= 40 ? text : text.substr(0, 40) + "...";
}

}  // namespace

bool Range::contains(double value) const {
  const bool above = without_lower ? value > lower : value >= lower;
  const bool below = without_upper ? value < upper : value <= upper;
  return above && below;
}

std::string Range::describe() const {
  if (upper == std::numeric_limits<double>::infinity()) {
    return fmt::format("{} {:g}", without_lower ? "above" : "of at least", lower);
  }
  return fmt::format("in {}{:g}, {:g}{}", without_lower ? '(' : '[', lower, upper,
                     without_upper ? ')' : ']');
}

void JsonView::fail(const std::string& reason) const {
  throw Error(ErrorKind::scene, *file_, pointer_, reason);
}

void JsonView::fail_type(std::string_view expected) const {
  fail(fmt::format("is {}, expected {}", shown(*value_), expected));
}

JsonView JsonView::child(std::string_view key, const Json& value) const {
  return {value, pointer_ + '/' + escape(key), *file_};
}

std::optional<JsonView> JsonView::find(std::string_view key) const {
  if (!value_->is_object()) {
    fail_type("an object");
  }
  const auto it = value_->find(key);
  if (it == value_->end()) {
    return std::nullopt;
  }
  return child(key, *it);
}

JsonView JsonView::require(std::string_view key) const {
  std::optional<JsonView> member = find(key);
  if (!member) {
    fail(fmt::format("has no \"{}\", which is required", key));
  }
  return *std::move(member);
}

JsonView JsonView::find_or_empty(std::string_view key) const {
  static const Json k_empty = Json::object();
  const std::optional<JsonView> member = find(key);
  return member ? *member : child(key, k_empty);
}

std::optional<JsonView> JsonView::extension(std::string_view name) const {
  const std::optional<JsonView> extensions = find("extensions");
  std::optional<JsonView> result = extensions ? extensions->find(name) : std::nullopt;
  if (result && !result->value_->is_object()) {
    result->fail_type("an object");
  }
  return result;
}

std::vector<std::string> JsonView::keys() const {
  if (!value_->is_object()) {
    fail_type("an object");
  }
  std::vector<std::string> result;
  for (const auto& member : value_->items()) {
    result.push_back(member.key());
  }
  return result;
}

std::vector<JsonView> JsonView::items() const {
  if (!value_->is_array()) {
    fail_type("an array");
  }
  std::vector<JsonView> result;
  result.reserve(value_->size());
  for (const Json& item : *value_) {
    result.emplace_back(item, pointer_ + '/' + std::to_string(result.size()), *file_);
  }
  return result;
}

std::vector<JsonView> JsonView::items(std::string_view key) const {
  const std::optional<JsonView> member = find(key);
  return member ? member->items() : std::vector<JsonView>{};
}

JsonView JsonView::item(std::string_view key, std::size_t index) const {
  const JsonView array = require(key);
  if (!array.value_->is_array() || index >= array.value_->size()) {
    array.fail_type(fmt::format("an array of more than {} items", index));
  }
  return {(*array.value_)[index], fmt::format("{}/{}", array.pointer_, index), *file_};
}

const std::string& JsonView::text() const {
  if (!value_->is_string()) {
    fail_type("a string");
  }
  return value_->get_ref<const std::string&>();
}

double JsonView::number(const Range& range) const {
  if (!value_->is_number()) {
    fail_type("a number");
  }
  const auto result = value_->get<double>();
  if (!range.contains(result)) {
    fail_type("a number " + range.describe());
  }
  return result;
}

std::uint64_t JsonView::integer() const {
  if (!value_->is_number_unsigned()) {
    fail_type("an integer of at least 0");
  }
  return value_->get<std::uint64_t>();
}

bool JsonView::boolean() const {
  if (!value_->is_boolean()) {
    fail_type("true or false");
  }
  return value_->get<bool>();
}

std::vector<double> JsonView::numbers(std::size_t count, const Range& range) const {
  if (!value_->is_array() || value_->size() != count) {
    fail_type(fmt::format("an array of {} numbers", count));
  }
  std::vector<double> result;
  for (const JsonView& item : items()) {
    result.push_back(item.number(range));
  }
  return result;
}

std::size_t JsonView::index(std::size_t size, std::string_view things) const {
  const std::uint64_t result = integer();
  if (result >= size) {
    fail(fmt::format("is {}, expected an index below {}, the number of {}", result, size, things));
  }
  return static_cast<std::size_t>(result);
}

std::string JsonView::text_or(std::string_view key, const std::string& fallback) const {
  const std::optional<JsonView> member = find(key);
  return member ? member->text() : fallback;
}

double JsonView::number_or(std::string_view key, double fallback, const Range& range) const {
  const std::optional<JsonView> member = find(key);
  return member ? member->number(range) : fallback;
}

std::uint64_t JsonView::integer_or(std::string_view key, std::uint64_t fallback) const {
  const std::optional<JsonView> member = find(key);
  return member ? member->integer() : fallback;
}

bool JsonView::boolean_or(std::string_view key, bool fallback) const {
  const std::optional<JsonView> member = find(key);
  return member ? member->boolean() : fallback;
}

std::vector<double> JsonView::numbers_or(std::string_view key, const std::vector<double>& fallback,
                                         const Range& range) const {
  const std::optional<JsonView> member = find(key);
  return member ? member->numbers(fallback.size(), range) : fallback;
}

std::optional<std::size_t> JsonView::index_of(std::string_view key, std::size_t size,
                                              std::string_view things) const {
  const std::optional<JsonView> member = find(key);
  return member ? std::optional(member->index(size, things)) : std::nullopt;
}

}  // namespace lume::io::gltf
