// SPDX-License-Identifier: MIT
// The program with all its commands, as main() makes it.
#pragma once

#include <memory>

#include <CLI/CLI.hpp>

#include "cli/command.h"

namespace polhode::test {

struct WholeProgram {
  WholeProgram() {
    app.add_flag("-v,--verbose", verbose, "print more on stderr");
    for (const Command& command : commands()) {
      CLI::App* sub = app.add_subcommand(command.name, command.doc);
      actions.push_back(command.define(*sub));
    }
  }
  bool verbose = false;
  CLI::App app{"Films of spinning bodies.", "polhode"};
  std::vector<Action> actions;  // own what the options are read into
};

}  // namespace polhode::test
