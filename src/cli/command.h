// SPDX-License-Identifier: MIT
// The table of commands. A file in cli/commands/ turns the options of each into a job and runs it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/divided_work.h"

namespace polhode {

// Runs a command after its options have been parsed, and returns the exit code of the process. It
// owns the variables into which the options are parsed, so it must be kept until parsing is over.
// Throws Error.
using Action = std::function<int()>;

// Checks and measures the work of a command after its options have been parsed, for `submit`.
// Throws Error.
using Divide = std::function<DividedWork()>;

// A row of the table. To add one: see ARCHITECTURE.md.
struct Command {
  const char* name;     // as typed after `polhode`
  const char* doc;      // one phrase, for --help and the manual page
  const char* example;  // the shortest useful call, with `polhode`
  // adds the options to the subcommand `command` and returns what to run after parsing; does not
  // run anything itself. `command` must outlive the Action, which may refer to it.
  Action (*define)(CLI::App& command);
  // does the same for work that several machines can do together; null: the command has none
  Divide (*divide)(CLI::App& command) = nullptr;
};

// All commands, in the order of --help. The table exists until the program ends.
const std::vector<Command>& commands();

// The `define` functions of the table, one per command; each has its file in cli/commands/, except
// that small commands share one.
Action define_new(CLI::App& command);
Action define_render(CLI::App& command);
Action define_join(CLI::App& command);
Action define_verify(CLI::App& command);
Action define_preview(CLI::App& command);
Action define_simulate(CLI::App& command);
Action define_plot(CLI::App& command);
Action define_export(CLI::App& command);
Action define_inspect(CLI::App& command);
Action define_chart(CLI::App& command);
Action define_stability(CLI::App& command);
Action define_section(CLI::App& command);
Action define_diff(CLI::App& command);
Action define_golden(CLI::App& command);
Action define_lecture(CLI::App& command);
Action define_submit(CLI::App& command);
Action define_status(CLI::App& command);
Action define_cancel(CLI::App& command);
Action define_list(CLI::App& command);
Action define_schema(CLI::App& command);
Action define_doctor(CLI::App& command);
Action define_manual(CLI::App& command);
Action define_completion(CLI::App& command);

// The `divide` functions of the table.
Divide divide_render(CLI::App& command);
Divide divide_chart(CLI::App& command);
Divide divide_stability(CLI::App& command);
Divide divide_section(CLI::App& command);
Divide divide_lecture(CLI::App& command);

// The command that runs another one in parts.
inline constexpr const char* kSubmit = "submit";

// The values of the argument ACTION of `golden`: run, update, show.
std::vector<std::string> golden_actions();

}  // namespace polhode
