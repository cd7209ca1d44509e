// SPDX-License-Identifier: MIT
#include "base/numbers.h"

#include <limits>

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(ParseInteger, TakesEveryIntAndNothingBeyond) {
  EXPECT_EQ(parse_integer("12"), 12);
  EXPECT_EQ(parse_integer("-3"), -3);
  EXPECT_EQ(parse_integer("007"), 7);
  EXPECT_EQ(parse_integer("2147483647"), std::numeric_limits<int>::max());
  EXPECT_EQ(parse_integer("-2147483648"), std::numeric_limits<int>::min());
  EXPECT_FALSE(parse_integer("2147483648"));
  EXPECT_FALSE(parse_integer("-2147483649"));
}

TEST(ParseInteger, RefusesTextThatIsNotWhollyANumber) {
  for (const char* text : {"", " 1", "1 ", "1.0", "1e3", "+1", "--1", "0x10", "1/2", "one"})
    EXPECT_FALSE(parse_integer(text)) << '\'' << text << '\'';
}

TEST(ParseNumber, ReadsDecimalsAndPowersToTheLastBit) {
  EXPECT_EQ(parse_number("2.5"), 2.5);
  EXPECT_EQ(parse_number("-1e-3"), -0.001);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("6"), 6.0);
  EXPECT_EQ(parse_number("1.7976931348623157e308"), std::numeric_limits<double>::max());
}

TEST(ParseNumber, RefusesInfinitiesAndTextThatIsNotWhollyANumber) {
  for (const char* text :
       {"", " 1", "1 ", "1,5", "1.5x", "+1", "inf", "-inf", "nan", "1e999", "1e", "e3"})
    EXPECT_FALSE(parse_number(text)) << '\'' << text << '\'';
}

// the view need not end where its text does
TEST(ParseNumber, ReadsNoFurtherThanTheViewReaches) {
  const std::string_view text = "12.75";
  EXPECT_EQ(parse_integer(text.substr(0, 2)), 12);
  EXPECT_EQ(parse_number(text.substr(1, 3)), 2.7);
}

}  // namespace
}  // namespace polhode
