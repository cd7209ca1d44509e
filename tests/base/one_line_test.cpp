// SPDX-License-Identifier: MIT
#include "base/one_line.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(OneLine, LetsNoControlCharacterThrough) {
  EXPECT_EQ(one_line("a\nb\tc\r\x1b[2J\x7f"), "a b c\\x0d\\x1b[2J\\x7f");
  EXPECT_EQ(one_line("\xC3\xA9"), "\xC3\xA9");  // UTF-8 stays
}

TEST(Cut, CutsBetweenCharacters) {
  EXPECT_EQ(cut("abc", 3), "abc");
  EXPECT_EQ(cut("abcd", 3), "abc...");
  EXPECT_EQ(cut("ab\xC3\xA9", 3), "ab...");
  EXPECT_EQ(cut("\xF0\x9F\x98\x80", 3), "...");
}

}  // namespace
}  // namespace polhode
