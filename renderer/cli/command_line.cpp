// SPDX-License-Identifier: Apache-2.0
// Finds the subcommand, and answers what is mistyped with what was probably meant.
#include "renderer/cli/command_line.h"

#include "io/error.h"
#include "renderer/cli/commands.h"
#include "renderer/cli/result_output.h"
#include "renderer/cli/suggest.h"
#include "renderer/cli/text.h"
#include "renderer/cli/version.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>
#include <string_view>

namespace lume::cli {
namespace {

constexpr std::string_view k_footer = R"(
Examples:
  lume render helmet.glb -o helmet.png                  a picture with all the defaults
  lume render helmet.glb -o helmet.exr --spp 256        scene-linear, less noise
  lume trace helmet.glb --pixel 640,360                 why a pixel has its colour
  lume bench helmet.glb                                 which structure is fastest
  lume compare out.png golden.png                       is it the same picture
  lume test manifest.toml                               do many pictures look as they did
  lume info helmet.glb                                  what the file holds
  lume check helmet.glb                                 what may be wrong with it
  lume render --help                                    everything a render can be told
)";

/// CLI11's help without "Needs:" and "Excludes:", which push descriptions out of their column.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    return option->get_type_name().empty() ? "" : " " + option->get_type_name();
  }
};

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// "--name" of "-name", "--name" and "--name=value".
std::string bare_option(const std::string& argument) {
  const std::string name = argument.substr(0, argument.find('='));
  return "--" + name.substr(std::min(name.find_first_not_of('-'), name.size()));
}

[[noreturn]] void reject_option(const CLI::App& app, const std::string& argument) {
  const bool is_main = app.get_parent() == nullptr;
  const std::string where = is_main ? "lume" : "lume " + app.get_name();
  // CLI11 leaves "-=4" of "-q=4".
  const bool nameless = bare_option(argument) == "--";
  const std::string shown = printable(nameless ? argument : argument.substr(0, argument.find('=')));
  std::string hint = nameless ? "" : did_you_mean(bare_option(argument), option_names(app));
  if (hint.empty() && is_main) hint = "; options stand after the subcommand";
  throw UsageError(fmt::format("unknown option '{}'{} ({} --help lists all)", shown, hint, where));
}

[[noreturn]] void reject_subcommand(const std::string& argument,
                                    const std::vector<Command>& commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const Command& command : commands) names.push_back(command.app->get_name());
  const std::string extension = std::filesystem::path(argument).extension().string();
  if (extension == ".gltf" || extension == ".glb") {
    throw UsageError(
        fmt::format("'{0}' is a file, not a subcommand; did you mean "
                    "'lume render {0} -o picture.png'?",
                    printable(argument)));
  }
  throw UsageError(unknown_name("subcommand", argument, names));
}

bool looks_like_option(const std::string& argument) {
  return argument.size() > 1 && argument[0] == '-';
}

/// What CLI11 set aside because it does not know it; it counts the "--" before positionals to that.
std::vector<std::string> leftovers(const CLI::App& app) {
  std::vector<std::string> left = app.remaining();
  left.erase(std::remove(left.begin(), left.end(), "--"), left.end());
  return left;
}

/// An unknown option explains what stands after it, so the first one is what to complain about.
void reject_leftovers(const CLI::App& main, const std::vector<Command>& commands) {
  const std::vector<std::string> before = leftovers(main);
  if (!before.empty()) {
    if (looks_like_option(before.front())) reject_option(main, before.front());
    reject_subcommand(before.front(), commands);
  }
  for (const Command& command : commands) {
    const std::vector<std::string> left = leftovers(*command.app);
    if (left.empty()) continue;
    const auto option = std::find_if(left.begin(), left.end(), looks_like_option);
    if (option != left.end()) reject_option(*command.app, *option);
    throw UsageError(
        fmt::format("unexpected argument '{}'; one scene at a time", printable(left.front())));
  }
}

/// True if CLI11 answered the arguments itself, by showing help or the version.
bool parse(CLI::App& main, const std::vector<std::string>& arguments) {
  // CLI11 takes the arguments from the back.
  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
  try {
    main.parse(std::move(reversed));
  } catch (const CLI::CallForVersion&) {
    print_result(version_text());
    return true;
  } catch (const CLI::Success&) {
    print_result(main.help());  // of the subcommand, if there is one
    return true;
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string_view text = error.what();
    throw UsageError(fmt::format("{} needs a value", text.substr(0, text.find(':'))));
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  return false;
}

}  // namespace

ExitCode run_command_line(const std::vector<std::string>& arguments) {
  CLI::App main("Lume renders glTF scenes on the CPU.", "lume");
  const auto formatter = std::make_shared<HelpFormatter>();
  formatter->column_width(34);
  main.formatter(formatter);
  main.require_subcommand(0, 1);
  main.allow_extras();
  main.set_version_flag("-V,--version", "");

  const std::vector<std::string> after(arguments.begin() + (arguments.empty() ? 0 : 1),
                                       arguments.end());
  const std::vector<Command> commands = {
      add_render_command(main, after), add_trace_command(main),
      add_bench_command(main, after),  add_compare_command(main, after),
      add_test_command(main, after),   add_info_command(main),
      add_check_command(main)};
  for (const Command& command : commands) command.app->allow_extras();
  main.footer(std::string(k_footer));  // last, for subcommands inherit what there is before them

  if (parse(main, arguments)) return ExitCode::success;
  reject_leftovers(main, commands);
  for (const Command& command : commands) {
    if (command.app->parsed()) return command.run();
  }
  throw UsageError(
      "no subcommand given; try: lume render SCENE.glb -o picture.png, or lume --help");
}

ExitCode report_current_exception() {
  const auto say = [](std::string_view message) {
    fmt::print(stderr, "lume: error: {}\n", printable(message));
  };
  try {
    throw;
  } catch (const UsageError& error) {
    say(error.what());
    return ExitCode::usage;
  } catch (const io::Error& error) {
    say(error.what());
    return static_cast<ExitCode>(error.kind());
  } catch (const std::bad_alloc&) {
    say("out of memory");
  } catch (const std::exception& error) {
    say(error.what());
  } catch (...) {
    say("something unforeseen happened");
  }
  return ExitCode::internal;
}

}  // namespace lume::cli
