// SPDX-License-Identifier: Apache-2.0
// The program lume-generate: one of the generator's characters, in a chosen size, as a .glb file.
#include "assets/generator/characters.h"
#include "assets/generator/write_scene.h"
#include "renderer/cli/argument_parsing.h"
#include "renderer/cli/command_line.h"
#include "renderer/cli/exit_codes.h"
#include "renderer/cli/result_output.h"
#include "renderer/cli/suggest.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lume::generator {
namespace {

using cli::ExitCode;
using cli::UsageError;

constexpr double k_fewest = 1e3;
constexpr double k_most = 1e7;

struct Options {
  std::string character;
  std::string triangles = "100k";
  std::string output;
};

const Character& find_character(std::string_view name) {
  std::vector<std::string> names;
  for (const Character& character : characters()) {
    if (character.name == name) return character;
    names.emplace_back(character.name);
  }
  throw UsageError(name.empty()
                       ? fmt::format("no character given (known: {})", cli::list_names(names))
                       : cli::unknown_name("character", name, names));
}

/// "30000", "250k", "1.5M". Throws UsageError.
std::size_t parse_count(std::string_view text) {
  std::string_view digits = text;
  double unit = 1.0;
  if (text.ends_with('k') || text.ends_with('K')) unit = 1e3;
  if (text.ends_with('M')) unit = 1e6;
  if (unit > 1.0) digits.remove_suffix(1);
  double count = 0.0;
  try {
    count = std::round(cli::parse_real(digits, 0.0, k_most) * unit);
  } catch (const UsageError&) {
    // Said below, with the suffix and the limits.
  }
  if (count < k_fewest || count > k_most) {
    throw UsageError(
        fmt::format("--triangles: expected 1000 to 10M (such as 30000, 250k, 2M), got '{}'",
                    cli::printable(text)));
  }
  return static_cast<std::size_t>(count);
}

std::filesystem::path parse_output(const std::string& text) {
  if (text.empty()) throw UsageError("no file to write given; try: -o scene.glb");
  if (std::filesystem::path(text).extension() != ".glb") {
    throw UsageError(
        fmt::format("-o: expected a name that ends in .glb, got '{}'", cli::printable(text)));
  }
  return text;
}

std::string footer() {
  std::string text = "\nCharacters:\n";
  for (const Character& character : characters()) {
    text += fmt::format("  {:<16}{}\n", character.name, character.description);
  }
  return text + R"(
Examples:
  lume-generate hair --triangles 250k -o hair.glb
  lume-generate statue --triangles 2M -o statue.glb && lume render statue.glb -o statue.png
)";
}

ExitCode run(const std::vector<std::string>& arguments) {
  Options options;
  CLI::App app("Writes scenes of any size for comparing acceleration structures.", "lume-generate");
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.add_option("CHARACTER", options.character, "What to make, see below")->type_name("NAME");
  app.add_option("--triangles", options.triangles, "About how many, 1000 to 10M (100k)")
      ->type_name("N");
  app.add_option("-o,--output", options.output, "The .glb file to write")->type_name("FILE");
  app.footer(footer());
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(),
                                       arguments.rend()));  // CLI11 takes them from the back
  } catch (const CLI::Success&) {
    cli::print_result(app.help());
    return ExitCode::success;
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  const Character& character = find_character(options.character);
  const std::size_t triangles = parse_count(options.triangles);
  const std::filesystem::path output = parse_output(options.output);
  const geometry::Mesh mesh = character.make(triangles);
  write_scene(output, character, mesh);
  cli::print_result(fmt::format("{}: {} triangles, {} positions\n", output.string(),
                                cli::format_count(mesh.triangles.size()),
                                cli::format_count(mesh.positions.size())));
  return ExitCode::success;
}

}  // namespace
}  // namespace lume::generator

int main(int argc, char** argv) {
  try {
    return static_cast<int>(lume::generator::run({argv + 1, argv + argc}));
  } catch (...) {
    return static_cast<int>(lume::cli::report_current_exception());
  }
}
