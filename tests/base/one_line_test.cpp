// SPDX-License-Identifier: MIT
#include "base/one_line.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(OneLine, LetsNoControlCharacterThrough) {
  EXPECT_EQ(one_line("a\nb\tc\r\x1b[2J\x7f"), "a b c\\x0d\\x1b[2J\\x7f");
  EXPECT_EQ(one_line("\xC3\xA9"), "\xC3\xA9");  // UTF-8 stays
}

}  // namespace
}  // namespace polhode
