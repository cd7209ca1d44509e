// SPDX-License-Identifier: MIT
#include "base/shell_word.h"

#include <gtest/gtest.h>

#include "base/system/child_process.h"

namespace polhode {
namespace {

TEST(ShellWord, PlainNamesStayAsTheyAre) {
  EXPECT_EQ(shell_word("scenes/heavy_top.toml"), "scenes/heavy_top.toml");
}

TEST(ShellWord, ADashIsNoOption) {
  EXPECT_EQ(shell_word("-v.toml"), "./-v.toml");
}

// the shell itself says what it reads
TEST(ShellWord, AShellReadsTheNameBack) {
  for (const std::string name :
       {"my film.toml", "it's.toml", "$(id).toml", "a\nb", "*", "", "ü \"x\"", "a\\b"}) {
    const ChildResult ran = run_child({"sh", "-c", "printf %s " + shell_word(name)}, "");
    EXPECT_EQ(ran.out, name);
  }
}

}  // namespace
}  // namespace polhode
