// SPDX-License-Identifier: MIT
// The program: options to a job, a job to an exit code, every error to one line.
#include <cstring>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/ranges.h>

#include "app/version_text.h"
#include "base/error.h"
#include "base/nearest.h"
#include "base/system/console.h"
#include "base/system/interrupt.h"
#include "base/system/log.h"
#include "cli/command.h"
#include "cli/commit.h"

namespace polhode {

namespace {

int fail(const Error& error) {
  print_err(fmt::format("polhode: {}\n", error.what()));
  return static_cast<int>(error.fault());
}

// a mistyped command gets the nearest one; CLI11 only says that it was unexpected
void refuse_unknown_command(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const Command& command : commands()) {
    if (std::strcmp(command.name, argv[1]) == 0) return;
    names.emplace_back(command.name);
  }
  throw input_error("unknown command '{}'{}", argv[1], suggestion(argv[1], names));
}

// the first word that is an option's name and that this command does not have; "" if there is none
std::string unknown_option(const std::vector<std::string>& known, int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    std::string word = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
    if (word.rfind("--", 0) != 0) continue;
    if (std::find(known.begin(), known.end(), word) == known.end()) return word;
  }
  return {};
}

// the parser's complaint in our words; a mistyped option gets the nearest one of its command
Error explain(const CLI::ParseError& error, const CLI::App& app, int argc, char** argv) {
  if (app.get_subcommands().empty()) {
    std::vector<std::string> names;
    for (const Command& command : commands())
      names.emplace_back(command.name);
    return input_error("give a command: {}; see `polhode --help`", fmt::join(names, ", "));
  }
  const CLI::App& command = *app.get_subcommands().front();
  std::string text = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    std::vector<std::string> known;
    for (const CLI::Option* option : command.get_options()) {
      for (const std::string& name : option->get_lnames())
        known.push_back("--" + name);
    }
    const std::string unknown = unknown_option(known, argc, argv);
    if (!unknown.empty()) {
      return input_error(
          "{} has no option {}{}", command.get_name(), unknown, suggestion(unknown, known));
    }
    const std::vector<std::string> left = app.remaining(true);
    const std::string word = left.empty() ? "" : left.front();
    text = word.starts_with("-") ? fmt::format("'{}' must come after the command", word)
                                 : fmt::format("unexpected argument '{}'", word);
  } else if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    // "--size: 1 required TEXT missing" in several wordings; the first word is the option
    text = text.substr(0, text.find(':')) + " needs a value";
  }
  return input_error(
      "{}: {}; see `polhode {} --help`", command.get_name(), text, command.get_name());
}

int run(int argc, char** argv) {
  CLI::App app("Physically exact films of spinning bodies, rendered without a window.", "polhode");
  app.set_version_flag("--version", version_text(program_commit()));
  bool verbose = false;
  app.add_flag("-v,--verbose", verbose, "print more on stderr");
  app.require_subcommand(1);
  app.fallthrough();
  app.footer(
      "Exit codes: 0 done, 1 a check said no, 2 bad input, 3 the environment failed, "
      "130 interrupted.\n`polhode COMMAND --help` tells the options of a command.");

  std::vector<std::pair<CLI::App*, Action>> actions;
  for (const Command& command : commands()) {
    CLI::App* sub = app.add_subcommand(command.name, command.doc);
    sub->footer(fmt::format("Example: {}", command.example));
    actions.emplace_back(sub, command.define(*sub));
  }
  refuse_unknown_command(argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {
    // --help, --version
    std::ostringstream text;
    const int code = app.exit(request, text, text);
    print_out(text.str());
    return code;
  } catch (const CLI::ParseError& error) {
    throw explain(error, app, argc, argv);
  }
  start_log(verbose);
  for (const auto& [sub, action] : actions) {
    if (sub->parsed()) return action();
  }
  return 0;
}

}  // namespace
}  // namespace polhode

int main(int argc, char** argv) {
  using polhode::Error;
  using polhode::Fault;
  polhode::guard_standard_streams();
  polhode::watch_for_interrupt();
  try {
    return polhode::run(argc, argv);
  } catch (const Error& error) {
    return polhode::fail(error);
  } catch (const std::bad_alloc&) {
    return polhode::fail(Error(Fault::environment, "out of memory"));
  } catch (const std::exception& error) {
    return polhode::fail(Error(Fault::environment, std::string("unexpected: ") + error.what()));
  }
}
