// SPDX-License-Identifier: MIT
// `manual` and `completion`: what the package installs for man and for shells.
#include <memory>

#include "base/error.h"
#include "base/nearest.h"
#include "base/system/console.h"
#include "base/system/output_folder.h"
#include "cli/command.h"
#include "cli/completions.h"
#include "cli/man_page.h"
#include "cli/shared_options.h"

namespace polhode {
namespace {

// polhode.1 and polhode-COMMAND.1 of all commands
void write_man_pages(const CLI::App& program, const std::string& folder) {
  std::vector<std::string> names = {"polhode.1"}, pages = {program_man_page(program)};
  for (const CLI::App* command : program.get_subcommands({})) {
    names.push_back("polhode-" + command->get_name() + ".1");
    pages.push_back(command_man_page(program, *command));
  }
  OutputFolder(folder, names).commit(pages);
}

std::string man_page(const CLI::App& program, const std::string& name) {
  if (name.empty()) return program_man_page(program);
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) {
    if (command->get_name() == name) return command_man_page(program, *command);
    names.push_back(command->get_name());
  }
  throw input_error("unknown command '{}'{}", name, suggestion(name, names)).at({{}, 0, "manual"});
}

}  // namespace

Action define_manual(CLI::App& command) {
  auto name = std::make_shared<std::string>();
  auto folder = std::make_shared<std::string>();
  command.add_option("name", *name, "page of this command (default: of the program)")
      ->type_name("COMMAND");
  add_text(command, "-o,--output", *folder, "write the pages of all commands into this folder")
      ->type_name("DIR");
  return [&command, name, folder] {
    const CLI::App& program = *command.get_parent();
    if (folder->empty()) {
      print_out(man_page(program, *name));
    } else if (!name->empty()) {
      throw input_error("writes the pages of all commands; leave '{}' out", *name)
          .at({{}, 0, "--output"});
    } else {
      write_man_pages(program, *folder);
    }
    return 0;
  };
}

Action define_completion(CLI::App& command) {
  auto shell = std::make_shared<std::string>();
  command.add_option("shell", *shell, "bash or zsh")->required()->type_name("SHELL");
  return [&command, shell] {
    const CLI::App& program = *command.get_parent();
    if (*shell == "bash") {
      print_out(bash_completion(program));
    } else if (*shell == "zsh") {
      print_out(zsh_completion(program));
    } else {
      throw input_error("unknown shell '{}'{}", *shell, suggestion(*shell, {"bash", "zsh"}))
          .at({{}, 0, "completion"});
    }
    return 0;
  };
}

}  // namespace polhode
