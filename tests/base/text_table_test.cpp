// SPDX-License-Identifier: MIT
#include "base/text_table.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(TextTable, ColumnsAreAsWideAsTheirWidestCell) {
  EXPECT_EQ(aligned({{"name", "order", "source"}, {"rk4", "4", "Kutta"}, {"explicit", "1", "E"}}),
            "name      order  source\n"
            "rk4       4      Kutta\n"
            "explicit  1      E\n");
}

TEST(TextTable, TheLastCellOfALineHasNoSpacesBehindIt) {
  EXPECT_EQ(aligned({{"a", "long last cell"}, {"b", "x"}}), "a  long last cell\nb  x\n");
}

// a row may end early: its last cell is free, and the columns behind it keep their places
TEST(TextTable, RowsMayDifferInLength) {
  EXPECT_EQ(aligned({{"a", "b", "c"}, {"a heading"}, {"d", "e"}}),
            "a          b  c\n"
            "a heading\n"
            "d          e\n");
}

TEST(TextTable, NothingIsAnEmptyText) {
  EXPECT_EQ(aligned({}), "");
  EXPECT_EQ(aligned({{}}), "\n");
}

}  // namespace
}  // namespace polhode
