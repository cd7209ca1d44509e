// SPDX-License-Identifier: MIT
#include "cli/value_kinds.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "cli/whole_program.h"

namespace polhode {
namespace {

TEST(ValueKinds, EachNameIsThereOnce) {
  std::set<std::string> names;
  for (const ValueKind& kind : value_kinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_EQ(find_value_kind(kind.name), &kind);
    const bool has_words =
        kind.form == ValueForm::word || kind.form == ValueForm::words_with_commas;
    EXPECT_EQ(kind.words.empty(), !has_words) << kind.name;
    EXPECT_TRUE(kind.endings.empty() || kind.form == ValueForm::file) << kind.name;
  }
  EXPECT_EQ(find_value_kind("N"), nullptr) << "nothing completes a number";
}

// a kind that no option has would be a mistyped name, and its option without completion
TEST(ValueKinds, EachIsTheValueOfSomeOption) {
  const test::WholeProgram program;
  std::set<std::string> used;
  for (const CLI::App* command : program.app.get_subcommands({})) {
    for (const CLI::Option* option : command->get_options())
      used.insert(option->get_type_name());
  }
  for (const ValueKind& kind : value_kinds())
    EXPECT_TRUE(used.contains(kind.name)) << kind.name;
}

TEST(ValueKinds, CommandsAreThoseOfTheTable) {
  const std::vector<std::string>& words = find_value_kind("COMMAND")->words;
  ASSERT_EQ(words.size(), commands().size());
  for (std::size_t i = 0; i < words.size(); ++i)
    EXPECT_EQ(words[i], commands()[i].name);
}

}  // namespace
}  // namespace polhode
