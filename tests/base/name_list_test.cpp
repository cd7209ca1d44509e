// SPDX-License-Identifier: MIT
#include "base/name_list.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"

namespace polhode {
namespace {

using Names = std::vector<std::string>;

TEST(Trimmed, KeepsWhatIsBetweenTheBlanks) {
  EXPECT_EQ(trimmed(" \n a b\t"), "a b");
  EXPECT_EQ(trimmed("\ta ", " "), "\ta");
  EXPECT_EQ(trimmed(" \t\n"), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(SplitNames, TakesWhatIsBetweenCommas) {
  EXPECT_EQ(split_names(""), Names());
  EXPECT_EQ(split_names("a"), Names{"a"});
  EXPECT_EQ(split_names("b,a,b"), (Names{"b", "a", "b"}));
  EXPECT_EQ(split_names("a,,b,"), (Names{"a", "", "b"}));
  EXPECT_EQ(split_names(" a b,  c ,d"), (Names{"a b", "c", "d"}));
  EXPECT_EQ(split_names("a, ,b"), (Names{"a", "", "b"}));
}

TEST(KnownNames, RefusesNamesOfNothing) {
  const Names known = {"body", "plane"};
  EXPECT_EQ(known_names("plane,body,plane", known, "case", "--cases"),
            (std::set<std::string>{"body", "plane"}));
  EXPECT_TRUE(known_names("", known, "case", "--cases").empty());
  test::expect_input_error(
      [&] { known_names(",", known, "case", "--cases"); }, "--cases", "a name is missing in ','");
  test::expect_input_error([&] { known_names("body,plan", known, "case", "--cases"); },
                           "--cases",
                           "unknown case 'plan' (did you mean 'plane'?)");
}

}  // namespace
}  // namespace polhode
