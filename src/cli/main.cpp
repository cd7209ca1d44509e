// SPDX-License-Identifier: MIT
// The program: options to a job, a job to an exit code, every error to one line.
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <malloc.h>
#include <new>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <sys/resource.h>

#include "app/version_text.h"
#include "base/error.h"
#include "base/system/console.h"
#include "base/system/interrupt.h"
#include "base/system/log.h"
#include "base/system/unfinished.h"
#include "cli/command.h"
#include "cli/commit.h"
#include "cli/parse_errors.h"

namespace polhode {

namespace {

int fail(const Error& error) {
  wait_if_ending();  // why has been said
  end_silently();
  print_err(fmt::format("polhode: {}\n", error.what()));
  return static_cast<int>(error.fault());
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

// without a file for a font its letters are boxes, and nobody says so; golden pictures, shards and
// lectures hold more open than shells allow by themselves
void allow_open_files() {
  constexpr rlim_t kLeast = 64, kWanted = 4096;
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  if (limit.rlim_cur < kWanted && limit.rlim_cur < limit.rlim_max) {
    const rlim_t before = std::exchange(limit.rlim_cur, std::min(limit.rlim_max, kWanted));
    if (setrlimit(RLIMIT_NOFILE, &limit) != 0) limit.rlim_cur = before;
  }
  if (limit.rlim_cur >= kLeast) return;
  throw environment_error(
      "only {} files may be open (ulimit -n); {} are needed", limit.rlim_cur, kLeast);
}

// a shell sets both limits of processor time, and at the second one the system kills at once: so
// the first is told a second before, in which what is unfinished is removed
void be_told_of_the_end_of_time() {
  rlimit limit{};
  if (getrlimit(RLIMIT_CPU, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
  if (limit.rlim_cur < limit.rlim_max || limit.rlim_cur < 2) return;
  --limit.rlim_cur;
  static_cast<void>(setrlimit(RLIMIT_CPU, &limit));
}

// What makes libraries talk on standard output. Pixman has obeyed before main().
void settle_environment() {
  unsetenv("FC_DEBUG");
  if (std::getenv("PIXMAN_DISABLE") != nullptr)
    throw environment_error("PIXMAN_DISABLE is set, with which pictures differ; unset it");
}

int run(int argc, char** argv) {
  settle_environment();
  refuse_small_stack();
  be_told_of_the_end_of_time();
  allow_open_files();
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
  std::vector<std::string> words(argv + 1, argv + argc);
  refuse_words_in_other_encodings(words);
  refuse_unknown_command(words);
  words = with_work_apart(app, std::move(words));
  try {
    parse_words(app, words);
  } catch (const CLI::Success& request) {
    // --help, --version
    std::ostringstream text;
    const int code = app.exit(request, text, text);
    print_out(text.str());
    return code;
  } catch (const CLI::ParseError& error) {
    throw explain(error, app, words);
  }
  start_log(verbose);
  for (const auto& [sub, action] : actions) {
    if (sub->parsed()) return action();
  }
  return 0;
}

// Exit codes are ours: a library that ends the process, as Mesa does after tests of its own, may
// call that a success.
bool has_come_back = false;
void tell_of_other_ends() {
  if (has_come_back) return;
  say_in_passing("polhode: a library has ended the program\n");
  end_at_once(static_cast<int>(Fault::environment));
}

int run_to_exit_code(int argc, char** argv) {
  try {
    const int code = run(argc, argv);
    wait_if_ending();
    return code;
  } catch (const Error& error) {
    return fail(error);
  } catch (const std::bad_alloc&) {
    return fail(Error(Fault::environment, "out of memory"));
  } catch (const std::system_error& error) {
    const bool lacks = error.code() == std::errc::resource_unavailable_try_again;
    return fail(
        environment_error("{}: {}",
                          lacks ? "a thread cannot be started (ulimit -u, -v)" : "unexpected",
                          error.what()));
  } catch (const std::exception& error) {
    return fail(Error(Fault::environment, std::string("unexpected: ") + error.what()));
  }
}

}  // namespace
}  // namespace polhode

int main(int argc, char** argv) {
  polhode::guard_standard_streams();
  polhode::keep_large_blocks_apart();
  polhode::watch_for_interrupt();
  static_cast<void>(std::atexit(polhode::tell_of_other_ends));
  const int code = polhode::run_to_exit_code(argc, argv);
  polhode::has_come_back = true;
  return code;
}
