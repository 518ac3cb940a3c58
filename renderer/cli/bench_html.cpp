// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/bench_plots.h"
#include "renderer/cli/bench_report.h"
#include "renderer/cli/svg_writer.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>

#include <string_view>

namespace lume::cli {
namespace {

constexpr std::string_view k_head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>lume bench</title>
<style>
body { background: #fff; color: #1a1a1a; margin: 2em auto; padding: 0 1em; max-width: 68em;
       font: 16px/1.5 "DejaVu Sans", Verdana, Arial, sans-serif; }
h1, h2, h3 { line-height: 1.2; margin: 1.6em 0 0.5em; }
h1 { margin-top: 0; }
h3 { font-size: 1em; }
code { background: #f0f0f0; padding: 0.2em 0.4em; overflow-wrap: anywhere; }
table { border-collapse: collapse; font-size: 0.85em; font-variant-numeric: tabular-nums;
        display: block; overflow-x: auto; }
th, td { padding: 0.25em 0.7em; text-align: right; border-bottom: 1px solid #ccc; white-space: nowrap; }
th { vertical-align: bottom; border-bottom: 2px solid #1a1a1a; }
th:first-child, td:first-child { text-align: left; }
svg { display: block; max-width: 100%; height: auto; }
</style>
</head>
<body>
)";

std::string paragraph(const std::string& text) { return "<p>" + xml_text(text) + "</p>\n"; }

}  // namespace

std::string bench_to_html(const BenchDocument& document) {
  const BenchOptions& options = document.options;
  std::string html(k_head);
  html += "<h1>Acceleration structures compared</h1>\n";
  html += paragraph(describe(document.machine));
  html += "<p><code>" + xml_text(bench_command(options)) + "</code></p>\n";
  html += paragraph(describe_method(document));
  for (const SceneBench& scene : document.scenes) {
    html += "<h2>" + xml_text(describe_scene(scene)) + "</h2>\n";
    html += "<h3>Rays a second, as a ratio to " +
            xml_text(printable(options.accelerators.front())) + "</h3>\n" + plot_ratios(scene);
    html += "<h3>Time to build against rays a second</h3>\n" + plot_build_against_rays(scene);
    html += "<h3>Memory</h3>\n" + plot_memory(scene);
    for (const TextTable& table : bench_tables(scene, options)) html += html_table(table);
    html += paragraph("Answers are compared with " + printable(scene.reference) + ".");
  }
  return html + "</body>\n</html>\n";
}

}  // namespace lume::cli
