// SPDX-License-Identifier: MIT
#include "base/error.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(Error, IsOneLineWithItsPlace) {
  EXPECT_STREQ(Error(Fault::input, "is wrong").what(), "is wrong");
  EXPECT_STREQ(Error(Fault::input, "is wrong", {"a.toml", 3, "body.mass"}).what(),
               "a.toml:3: body.mass: is wrong");
  EXPECT_STREQ(Error(Fault::input, "is wrong", {"a.toml", 0, ""}).what(), "a.toml: is wrong");
  EXPECT_STREQ(Error(Fault::input, "is wrong", {"", 0, "--size"}).what(), "--size: is wrong");
}

TEST(Error, LetsNoControlCharacterThrough) {
  const Error error(Fault::input, "a\nb\tc\x1b[2J\x7f", {"f\r", 1, "k\x01"});
  EXPECT_STREQ(error.what(), "f\\x0d:1: k\\x01: a b c\\x1b[2J\\x7f");
  // UTF-8 stays
  EXPECT_STREQ(Error(Fault::input, "\xC3\xA9").what(), "\xC3\xA9");
}

TEST(Error, AtFillsOnlyWhatIsUnknown) {
  const Error inner = Error(Fault::environment, "no", {"", 0, "body"});
  const Error outer = inner.at({"a.toml", 7, "other"});
  EXPECT_STREQ(outer.what(), "a.toml:7: body: no");
  EXPECT_EQ(outer.fault(), Fault::environment);
  EXPECT_EQ(outer.message(), "no");
  EXPECT_STREQ(outer.at({"b.toml", 9, "c"}).what(), outer.what());
}

TEST(Error, FaultsAreTheExitCodes) {
  EXPECT_EQ(static_cast<int>(Fault::check_failed), 1);
  EXPECT_EQ(static_cast<int>(input_error("{}", 1).fault()), 2);
  EXPECT_EQ(static_cast<int>(environment_error("{}", 1).fault()), 3);
  EXPECT_EQ(static_cast<int>(Fault::interrupted), 130);
}

}  // namespace
}  // namespace polhode
