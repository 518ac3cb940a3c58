// SPDX-License-Identifier: Apache-2.0
// As much of JSON Schema (draft 2020-12) as the schemas in docs/schema use. A keyword that this
// does not know is an error, so that none is passed over.
#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace lume::test {

class JsonSchema {
 public:
  explicit JsonSchema(nlohmann::json schema) : root_(std::move(schema)) {}

  [[nodiscard]] const nlohmann::json& json() const { return root_; }
  [[nodiscard]] bool accepts(const nlohmann::json& value) const { return accepts(root_, value); }

 private:
  using Json = nlohmann::json;

  [[nodiscard]] bool accepts(const Json& schema, const Json& value) const {
    return std::all_of(schema.items().begin(), schema.items().end(), [&](const auto& keyword) {
      return obeys(keyword.key(), keyword.value(), value);
    });
  }

  [[nodiscard]] bool obeys(const std::string& keyword, const Json& rule, const Json& value) const {
    static const std::vector<std::string> k_words = {"$schema", "$id",         "$defs",
                                                     "title",   "description", "default"};
    if (std::find(k_words.begin(), k_words.end(), keyword) != k_words.end()) return true;
    if (keyword == "$ref") {
      const std::string pointer = rule.get<std::string>().substr(1);  // #/$defs/...
      return accepts(root_.at(Json::json_pointer(pointer)), value);
    }
    if (keyword == "type") return has_type(rule, value);
    if (keyword == "enum") return std::find(rule.begin(), rule.end(), value) != rule.end();
    if (keyword == "oneOf") {
      return std::count_if(rule.begin(), rule.end(),
                           [&](const Json& each) { return accepts(each, value); }) == 1;
    }
    if (keyword.find("Items") != std::string::npos || keyword == "items") {
      return !value.is_array() || obeys_array(keyword, rule, value);
    }
    if (keyword.find("Length") != std::string::npos) {
      return !value.is_string() || obeys_text(keyword, rule, value.get<std::string>());
    }
    if (keyword == "properties" || keyword == "required" || keyword == "dependentRequired") {
      return !value.is_object() || obeys_object(keyword, rule, value);
    }
    return obeys_number(keyword, rule, value);
  }

  static bool has_type(const Json& rule, const Json& value) {
    if (rule == "object") return value.is_object();
    if (rule == "array") return value.is_array();
    if (rule == "string") return value.is_string();
    if (rule == "boolean") return value.is_boolean();
    if (rule == "number") return value.is_number();
    if (rule == "integer") {
      return value.is_number() && std::floor(value.get<double>()) == value.get<double>();
    }
    throw std::invalid_argument("unknown type " + rule.dump());
  }

  [[nodiscard]] bool obeys_array(const std::string& keyword, const Json& rule,
                                 const Json& value) const {
    if (keyword == "items") {
      return std::all_of(value.begin(), value.end(),
                         [&](const Json& item) { return accepts(rule, item); });
    }
    if (keyword == "minItems") return value.size() >= rule.get<std::size_t>();
    if (keyword == "maxItems") return value.size() <= rule.get<std::size_t>();
    throw std::invalid_argument("unknown keyword " + keyword);
  }

  static bool obeys_text(const std::string& keyword, const Json& rule, const std::string& text) {
    if (keyword == "minLength") return text.size() >= rule.get<std::size_t>();
    if (keyword == "maxLength") return text.size() <= rule.get<std::size_t>();
    throw std::invalid_argument("unknown keyword " + keyword);
  }

  [[nodiscard]] bool obeys_object(const std::string& keyword, const Json& rule,
                                  const Json& value) const {
    const auto has_all = [&](const Json& names) {
      return std::all_of(names.begin(), names.end(),
                         [&](const Json& name) { return value.contains(name.get<std::string>()); });
    };
    if (keyword == "required") return has_all(rule);
    return std::all_of(rule.items().begin(), rule.items().end(), [&](const auto& each) {
      if (!value.contains(each.key())) return true;
      return keyword == "properties" ? accepts(each.value(), value.at(each.key()))
                                     : has_all(each.value());
    });
  }

  static bool obeys_number(const std::string& keyword, const Json& rule, const Json& value) {
    const double limit = rule.is_number() ? rule.get<double>() : std::nan("");
    const double number = value.is_number() ? value.get<double>() : limit;
    if (keyword == "minimum") return number >= limit;
    if (keyword == "maximum") return number <= limit;
    if (keyword == "exclusiveMinimum") return !value.is_number() || number > limit;
    if (keyword == "exclusiveMaximum") return !value.is_number() || number < limit;
    throw std::invalid_argument("unknown keyword " + keyword);
  }

  Json root_;
};

}  // namespace lume::test
