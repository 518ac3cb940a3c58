// SPDX-License-Identifier: Apache-2.0
#include "io/report/page_template.h"

#include <algorithm>
#include <array>

namespace lume::io {

// Written at build time by cmake/EmbedText.cmake.
extern const std::string_view k_page_viewer_html;
extern const std::string_view k_page_viewer_css;
extern const std::string_view k_page_pixels_js;
extern const std::string_view k_page_layers_js;
extern const std::string_view k_page_canvas_js;
extern const std::string_view k_page_readout_js;
extern const std::string_view k_page_viewer_js;
extern const std::string_view k_page_input_js;
extern const std::string_view k_page_list_js;
extern const std::string_view k_page_main_js;

namespace {

std::string all_scripts() {
  std::string scripts;
  for (const std::string_view script :
       {k_page_pixels_js, k_page_layers_js, k_page_canvas_js, k_page_readout_js, k_page_viewer_js,
        k_page_input_js, k_page_list_js, k_page_main_js}) {
    scripts += script;
  }
  return scripts;
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string html;
  html.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      case '\'':
        html += "&#39;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7F) html += c;
    }
  }
  return html;
}

std::string fill_page(const std::vector<std::pair<std::string_view, std::string>>& values) {
  std::string page;
  std::string_view rest = k_page_viewer_html;
  for (std::size_t open = rest.find("{{"); open != std::string_view::npos; open = rest.find("{{")) {
    page += rest.substr(0, open);
    const std::size_t close = rest.find("}}", open);
    const std::string_view name = rest.substr(open + 2, close - open - 2);
    const auto value = std::find_if(values.begin(), values.end(),
                                    [&](const auto& pair) { return pair.first == name; });
    if (name == "style") page += k_page_viewer_css;
    if (name == "script") page += all_scripts();
    if (value != values.end()) page += value->second;
    rest.remove_prefix(close + 2);
  }
  return page.append(rest);
}

}  // namespace lume::io
