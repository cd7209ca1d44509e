// SPDX-License-Identifier: MIT
#include "base/fields.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(WithinMagnitude, CutsARangeDownToTheUnit) {
  const Magnitude length = magnitude_of(Unit::length);
  ASSERT_GT(length.least, 0.0);
  ASSERT_LT(length.least, length.most);

  const Range any = within_magnitude(kAny, Unit::length);
  EXPECT_EQ(any.low, -length.most);
  EXPECT_EQ(any.high, length.most);

  // above zero means at least the least that the unit knows, which then belongs to the range
  const Range positive = within_magnitude(kPositive, Unit::length);
  EXPECT_EQ(positive.low, length.least);
  EXPECT_FALSE(positive.low_open);

  const Range non_negative = within_magnitude(kNonNegative, Unit::length);
  EXPECT_EQ(non_negative.low, 0.0);
  EXPECT_FALSE(non_negative.low_open);
}

TEST(WithinMagnitude, KeepsWhatIsNarrower) {
  const Range narrow = within_magnitude({0.25, 0.75, true}, Unit::length);
  EXPECT_EQ(narrow.low, 0.25);
  EXPECT_EQ(narrow.high, 0.75);
  EXPECT_TRUE(narrow.low_open);
}

}  // namespace
}  // namespace polhode
