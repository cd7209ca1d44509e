// SPDX-License-Identifier: MIT
#include "base/csv.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

// RFC 4180, section 2, rules 5 to 7
TEST(CsvField, IsQuotedOnlyWhereItMustBe) {
  EXPECT_EQ(csv_field(""), "");
  EXPECT_EQ(csv_field("a b;c'd"), "a b;c'd");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(csv_field("two\rlines"), "\"two\rlines\"");
  EXPECT_EQ(csv_field("say \"so\""), "\"say \"\"so\"\"\"");
}

}  // namespace
}  // namespace polhode
