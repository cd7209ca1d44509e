// SPDX-License-Identifier: MIT
// Completions as the shell itself gives them.
#include "cli/completions.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>

#include "cli/option_words.h"
#include "cli/whole_program.h"
#include "support/run.h"

namespace polhode {
namespace {

using Words = std::vector<std::string>;

class Completions : public ::testing::Test {
 protected:
  Completions() { test::write_text(script_, bash_completion(test::WholeProgram().app)); }

  // what bash offers behind these words; the last one is being typed
  Words offered(const Words& line) const {
    std::string words, before = line.size() > 1 ? line[line.size() - 2] : "";
    for (const std::string& word : line)
      words += " '" + word + "'";
    test::write_text(folder_ / "ask",
                     "compopt() { :; }\nsource '" + script_ + "'\ncd '" + files_ +
                         "'\nCOMP_WORDS=(" + words +
                         ")\nCOMP_CWORD=$(( ${#COMP_WORDS[@]} - 1 ))\n" + "_polhode polhode '" +
                         line.back() + "' '" + before + "'\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n");
    EXPECT_EQ(
        std::system(("bash '" + (folder_ / "ask") + "' >'" + (folder_ / "told") + "'").c_str()), 0);
    std::istringstream lines(test::read_text(folder_ / "told"));
    Words found;
    for (std::string one; std::getline(lines, one);) {
      if (!one.empty()) found.push_back(one);
    }
    return found;
  }
  void file(const std::string& name) const {
    std::filesystem::create_directories(files_);
    test::write_text(files_ + "/" + name, "");
  }

  test::TemporaryFolder folder_;
  std::string script_ = folder_ / "polhode.bash", files_ = folder_ / "here";
};

TEST_F(Completions, CommandsAreCompleted) {
  std::filesystem::create_directories(files_);
  EXPECT_EQ(offered({"polhode", "re"}), (Words{"render"}));
  EXPECT_EQ(offered({"polhode", ""}).size(), commands().size());
}

TEST_F(Completions, OptionsAndTheirWordsAreCompleted) {
  std::filesystem::create_directories(files_);
  EXPECT_EQ(offered({"polhode", "render", "--back"}), (Words{"--backend"}));
  EXPECT_EQ(offered({"polhode", "render", "--backend", ""}), backend_words());
  EXPECT_EQ(offered({"polhode", "render", "--backend", "=", "os"}), (Words{"osmesa"}))
      << "--backend=os arrives as three words";
  EXPECT_TRUE(offered({"polhode", "render", "--step", ""}).empty()) << "a number";
  EXPECT_EQ(offered({"polhode", "render", "--method", "au"}), (Words{"auto"}));
  EXPECT_EQ(offered({"polhode", "inspect", "--method", "exa"}), (Words{"exact"}));
  EXPECT_TRUE(offered({"polhode", "chart", "--methods", "au"}).empty()) << "it takes none";
}

TEST_F(Completions, WordsBeforeACommandDoNotHideIt) {
  file("a.toml");
  EXPECT_EQ(offered({"polhode", "--verbose", "re"}), (Words{"render"}));
  EXPECT_EQ(offered({"polhode", "--verbose", "render", ""}), (Words{"a.toml"}));
  EXPECT_EQ(offered({"polhode", "submit", "--wait", "rend"}), (Words{"render"}));
  EXPECT_EQ(offered({"polhode", "submit", "--tasks", "4", "render", ""}), (Words{"a.toml"}));
  EXPECT_EQ(offered({"polhode", "submit", "render", "a.toml", "--back"}), (Words{"--backend"}));
}

TEST_F(Completions, ListsGoOnBehindTheComma) {
  std::filesystem::create_directories(files_);
  EXPECT_EQ(offered({"polhode", "chart", "--methods", "rk4,gauss6"}), (Words{"rk4,gauss6"}));
}

TEST_F(Completions, ScenesAreFilesOfTheirEnding) {
  file("a.toml");
  file("b.png");
  EXPECT_EQ(offered({"polhode", "render", ""}), (Words{"a.toml"}));
  EXPECT_EQ(offered({"polhode", "render", "-o", "x.mp4", "--quiet", ""}), (Words{"a.toml"}))
      << "options and their values are no arguments";
}

// every command with every long option is in the script of zsh, and zsh can read it
TEST_F(Completions, ZshHasEveryOption) {
  const test::WholeProgram program;
  const std::string script = zsh_completion(program.app);
  EXPECT_TRUE(script.starts_with("#compdef polhode\n"));
  for (const CLI::App* command : program.app.get_subcommands({})) {
    const std::size_t begin = script.find("    " + command->get_name() + ")\n");
    ASSERT_NE(begin, std::string::npos) << command->get_name();
    const std::string part = script.substr(begin, script.find(";;\n", begin) - begin);
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& name : option->get_lnames()) {
        if (option->get_positional()) continue;
        EXPECT_NE(part.find("--" + name), std::string::npos) << command->get_name() << ' ' << name;
      }
    }
  }
  test::write_text(folder_ / "_polhode", script);
  EXPECT_EQ(std::system(("zsh -n '" + (folder_ / "_polhode") + "'").c_str()), 0);
}

}  // namespace
}  // namespace polhode
