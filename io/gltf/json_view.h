// SPDX-License-Identifier: Apache-2.0
// A JSON value that knows where it stands in which file, so that whatever is wrong with it can be
// said in one line. All members throw Error(scene) when the value is not what they promise.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lume::io::gltf {

using Json = nlohmann::json;

/// The numbers a property may have.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool without_lower = false;  ///< lower itself is not allowed
  bool without_upper = false;

  [[nodiscard]] bool contains(double value) const;
  [[nodiscard]] std::string describe() const;  ///< "in [0, 1]"
};
inline constexpr Range k_any{};
inline constexpr Range k_unit{0.0, 1.0};
inline constexpr Range k_not_negative{0.0};
inline constexpr Range k_positive{.lower = 0.0, .without_lower = true};

class JsonView {
 public:
  /// Both `value` and `file` must outlive the view and all that are taken from it.
  JsonView(const Json& value, std::string pointer, const std::string& file)
      : value_(&value), pointer_(std::move(pointer)), file_(&file) {}

  [[nodiscard]] const std::string& pointer() const { return pointer_; }
  [[noreturn]] void fail(const std::string& reason) const;

  // Objects.
  [[nodiscard]] std::optional<JsonView> find(std::string_view key) const;
  [[nodiscard]] JsonView require(std::string_view key) const;
  [[nodiscard]] bool has(std::string_view key) const { return find(key).has_value(); }
  /// An object without members if it is absent.
  [[nodiscard]] JsonView find_or_empty(std::string_view key) const;
  /// extensions.NAME, if it is there.
  [[nodiscard]] std::optional<JsonView> extension(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> keys() const;

  // Arrays. The array under `key`, item by item; none if it is absent.
  [[nodiscard]] std::vector<JsonView> items() const;
  [[nodiscard]] std::vector<JsonView> items(std::string_view key) const;
  /// One item of the array under `key`; it must exist.
  [[nodiscard]] JsonView item(std::string_view key, std::size_t index) const;

  // Values.
  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] double number(const Range& range = k_any) const;
  [[nodiscard]] std::uint64_t integer() const;  ///< 0 or more
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] std::vector<double> numbers(std::size_t count, const Range& range = k_any) const;
  /// An integer below `size`, the number of `things`.
  [[nodiscard]] std::size_t index(std::size_t size, std::string_view things) const;

  // Members with a default.
  [[nodiscard]] std::string text_or(std::string_view key, const std::string& fallback) const;
  [[nodiscard]] double number_or(std::string_view key, double fallback, const Range& range) const;
  [[nodiscard]] std::uint64_t integer_or(std::string_view key, std::uint64_t fallback) const;
  [[nodiscard]] bool boolean_or(std::string_view key, bool fallback) const;
  [[nodiscard]] std::vector<double> numbers_or(std::string_view key,
                                               const std::vector<double>& fallback,
                                               const Range& range) const;
  [[nodiscard]] std::optional<std::size_t> index_of(std::string_view key, std::size_t size,
                                                    std::string_view things) const;

 private:
  [[nodiscard]] JsonView child(std::string_view key, const Json& value) const;
  [[noreturn]] void fail_type(std::string_view expected) const;

  const Json* value_;
  std::string pointer_;  ///< RFC 6901
  const std::string* file_;
};

}  // namespace lume::io::gltf
