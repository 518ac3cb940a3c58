// SPDX-License-Identifier: Apache-2.0
#include "io/report/junit.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string_view>

namespace lume::io {
namespace {

using Outcome = JunitCase::Outcome;

/// How many bytes the character at the beginning has; 0 for what is no UTF-8 (RFC 3629) or no
/// character of XML 1.0.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  unsigned code = first & (0xffu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0u) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3fu);
  }
  constexpr unsigned k_least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xd800 && code <= 0xdfff;
  const bool is_character = code >= k_least[length] && code <= 0x10ffff && code != 0xfffe &&
                            code != 0xffff && !is_surrogate && first >= 0xc2 && first <= 0xf4;
  return is_character ? length : 0;
}

std::string allowed(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    result += length > 0 ? text.substr(0, length) : std::string_view("\xef\xbf\xbd");
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(allowed(value).c_str());
}

/// Without an exponent, which not every reader takes.
std::string in_seconds(double seconds) { return fmt::format("{:.3f}", seconds); }

void set_counts(pugi::xml_node node, const JunitSuite& suite) {
  const auto count = [&](Outcome outcome) {
    return std::to_string(std::count_if(suite.cases.begin(), suite.cases.end(),
                                        [&](const auto& one) { return one.outcome == outcome; }));
  };
  set(node, "tests", std::to_string(suite.cases.size()));
  set(node, "failures", count(Outcome::failed));
  set(node, "errors", count(Outcome::error));
  set(node, "skipped", count(Outcome::skipped));
  set(node, "time", in_seconds(suite.seconds));
}

const char* element_name(Outcome outcome) {
  switch (outcome) {
    case Outcome::failed:
      return "failure";
    case Outcome::error:
      return "error";
    case Outcome::skipped:
      return "skipped";
    case Outcome::passed:
      break;
  }
  return nullptr;
}

void append_case(pugi::xml_node parent, const JunitSuite& suite, const JunitCase& one) {
  pugi::xml_node node = parent.append_child("testcase");
  set(node, "name", one.name);
  set(node, "classname", suite.class_name);
  set(node, "file", suite.file);
  set(node, "time", in_seconds(one.seconds));
  if (!one.properties.empty()) {
    pugi::xml_node properties = node.append_child("properties");
    for (const auto& [name, value] : one.properties) {
      pugi::xml_node property = properties.append_child("property");
      set(property, "name", name);
      set(property, "value", value);
    }
  }
  if (const char* element = element_name(one.outcome); element != nullptr) {
    pugi::xml_node why = node.append_child(element);
    set(why, "message", one.message);
    if (!one.details.empty()) why.text().set(allowed(one.details).c_str());
  }
}

}  // namespace

std::string to_junit(const JunitSuite& suite) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node root = document.append_child("testsuites");
  set(root, "name", suite.name);
  set_counts(root, suite);
  pugi::xml_node node = root.append_child("testsuite");
  set(node, "name", suite.name);
  set_counts(node, suite);
  if (!suite.timestamp.empty()) set(node, "timestamp", suite.timestamp);
  for (const JunitCase& one : suite.cases) append_case(node, suite, one);
  std::ostringstream text;
  document.save(text, "  ", pugi::format_indent, pugi::encoding_utf8);
  return text.str();
}

}  // namespace lume::io
