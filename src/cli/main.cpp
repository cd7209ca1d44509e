// SPDX-License-Identifier: MIT
// The program: options to a job, a job to an exit code, every error to one line.
#include <cctype>
#include <cstring>
#include <exception>
#include <malloc.h>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/ranges.h>
#include <sys/resource.h>

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

// the option in "--size=12x12" and "-oFILE"; "" if the word has none, such as "-" and "-1.5"
std::string option_in(const std::string& word) {
  if (word.starts_with("--")) return word == "--" ? "" : word.substr(0, word.find('='));
  const bool letter = word.size() > 1 && std::isalpha(static_cast<unsigned char>(word[1])) != 0;
  return letter && word[0] == '-' ? word.substr(0, 2) : "";
}

// the first option that this command does not have; "" if there is none
std::string unknown_option(const std::vector<std::string>& known, int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    std::string option = option_in(argv[i]);
    if (option.empty()) continue;
    if (std::find(known.begin(), known.end(), option) == known.end()) return option;
  }
  return {};
}

void add_names(const CLI::App& app,
               std::vector<std::string>& long_names,
               std::vector<std::string>& all) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      long_names.push_back("--" + name);
      all.push_back("--" + name);
    }
    for (const std::string& name : option->get_snames())
      all.push_back("-" + name);
  }
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
    std::vector<std::string> own, of_program, all;
    add_names(command, own, all);
    add_names(app, of_program, all);
    const std::string unknown = unknown_option(all, argc, argv);
    if (!unknown.empty()) {
      // one letter is near to every other
      const std::string hint = unknown.starts_with("--")
                                   ? suggestion(unknown, own)
                                   : fmt::format(" (known: {})", fmt::join(own, ", "));
      return input_error("{} has no option {}{}", command.get_name(), unknown, hint);
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

// Frames are large and short-lived. Among what is small and kept, they would leave gaps into which
// the next one does not fit: several gigabytes of them in a long film.
void keep_large_blocks_apart() {
#ifdef M_MMAP_THRESHOLD
  constexpr int kLarge = 1 << 20;  // bytes
  mallopt(M_MMAP_THRESHOLD, kLarge);
#endif
}

// a stack that overflows is a crash with no reason
void refuse_small_stack() {
  constexpr rlim_t kLeast_KB = 512;
  rlimit limit{};
  if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >> 10 >= kLeast_KB) return;
  throw environment_error("the stack may have {} KB only (ulimit -s); {} KB are needed",
                          limit.rlim_cur >> 10,
                          kLeast_KB);
}

int run(int argc, char** argv) {
  refuse_small_stack();
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
  polhode::keep_large_blocks_apart();
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
