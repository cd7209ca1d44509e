// SPDX-License-Identifier: MIT
// Manual pages as groff sets them.
#include "cli/man_page.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "cli/whole_program.h"
#include "support/run.h"

namespace polhode {
namespace {

// the page as a reader sees it; what groff complains of is in `complaints`
struct Page {
  std::string text, complaints;
};

Page set_by_groff(const std::string& source) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "page.1", source);
  const std::string command = "groff -man -Tutf8 -P-cbou -ww '" + (folder / "page.1") + "' >'" +
                              (folder / "out") + "' 2>'" + (folder / "err") + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
  return {test::read_text(folder / "out"), test::read_text(folder / "err")};
}

// words as they stand in the page, whatever the lines are broken into
bool says(const std::string& page, const std::string& words) {
  std::string flat;
  for (const char c : page) {
    const bool space = c == ' ' || c == '\n';
    if (!space || flat.empty() || flat.back() != ' ') flat += space ? ' ' : c;
  }
  return flat.find(words) != std::string::npos;
}

// each page is set without a warning, and holds every option of its command with its words
TEST(ManPage, EveryCommandsPageIsSetWithItsOptions) {
  const test::WholeProgram program;
  for (const CLI::App* command : program.app.get_subcommands({})) {
    SCOPED_TRACE(command->get_name());
    const std::string source = command_man_page(program.app, *command);
    const Page page = set_by_groff(source);
    EXPECT_EQ(page.complaints, "");
    EXPECT_TRUE(says(page.text, "NAME polhode-" + command->get_name()));
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& name : option->get_lnames()) {
        if (option->get_positional()) continue;
        EXPECT_NE(page.text.find("--" + name), std::string::npos) << name;
      }
    }
    EXPECT_TRUE(says(page.text, "EXIT STATUS 0 Done."));
  }
}

TEST(ManPage, TheProgramsPageNamesEveryCommand) {
  const test::WholeProgram program;
  const Page page = set_by_groff(program_man_page(program.app));
  EXPECT_EQ(page.complaints, "");
  for (const Command& command : commands()) {
    const std::string doc = command.doc;
    // groff sets another apostrophe
    EXPECT_TRUE(says(page.text, doc.substr(0, doc.find('\'')))) << command.name;
  }
}

// what stands in a description stays text, whatever groff might read into it
TEST(ManPage, TextIsNoMacro) {
  CLI::App program("A program.", "polhode");
  CLI::App* command = program.add_subcommand("render", ".SH no 'heading' \\fB -x `y` ^z ~w");
  const Page page = set_by_groff(command_man_page(program, *command));
  EXPECT_EQ(page.complaints, "");
  EXPECT_TRUE(says(page.text, ".SH no 'heading' \\fB -x `y` ^z ~w")) << page.text;
}

}  // namespace
}  // namespace polhode
