// SPDX-License-Identifier: Apache-2.0
// A table of a manifest, read key by key. Whatever is not as expected is a ManifestError that names
// the line.
#pragma once

#include "io/image_tests/manifest.h"

#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lume::io {

class ManifestTable {
 public:
  /// `where` is what the table is called in messages: "[defaults]". A key that is none of `keys` is
  /// refused. File and table outlive this.
  ManifestTable(const std::filesystem::path& file, const toml::table& table, std::string where,
                const std::vector<std::string>& keys);

  /// The line on which the table begins, or on which the value of a key stands.
  [[nodiscard]] int line() const { return line_of(table_); }
  [[nodiscard]] int line(std::string_view key) const;
  [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }

  // Absent where the key is.
  [[nodiscard]] std::optional<std::string> text(std::string_view key) const;
  [[nodiscard]] std::optional<double> number(std::string_view key, double low, double high) const;
  [[nodiscard]] std::optional<int> whole(std::string_view key, int low, int high) const;
  /// An array of texts; nothing if the key is absent.
  [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;
  /// The same, or one text alone.
  [[nodiscard]] std::vector<std::string> text_or_texts(std::string_view key) const;
  [[nodiscard]] const toml::table* table(std::string_view key) const;
  /// The tables of an array [[key]].
  [[nodiscard]] std::vector<const toml::table*> tables(std::string_view key) const;

  [[noreturn]] void fail(int line, const std::string& message) const;
  /// "[[case]]: KEY: expected ..., found ...".
  [[noreturn]] void fail_value(std::string_view key, const std::string& expected) const;

 private:
  [[nodiscard]] static int line_of(const toml::node& node) {
    return static_cast<int>(node.source().begin.line);
  }

  const std::filesystem::path& file_;
  const toml::table& table_;
  std::string where_;
};

}  // namespace lume::io
