// SPDX-License-Identifier: MIT
#include "base/check.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(CheckDeathTest, AbortsWithPlaceAndCondition) {
  EXPECT_DEATH(CHECK(1 + 1 == 3), "check_test.cpp:[0-9]+: broken promise: 1 \\+ 1 == 3");
}

TEST(Check, LooksAtItsConditionOnce) {
  int looks = 0;
  CHECK(++looks == 1);
  EXPECT_EQ(looks, 1);
}

}  // namespace
}  // namespace polhode
