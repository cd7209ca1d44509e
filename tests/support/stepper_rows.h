// SPDX-License-Identifier: MIT
// The rows of the stepper table as parameters of tests, named by the method; those for tables have
// tests of their own.
#pragma once

#include <ostream>
#include <vector>

#include <gtest/gtest.h>

#include "motion/stepper_table.h"

namespace polhode {

// found by the test framework through the namespace of StepperInfo
inline void PrintTo(const StepperInfo& row, std::ostream* out) {
  *out << row.name;
}

namespace test {

class StepperTest : public testing::TestWithParam<StepperInfo> {};

inline auto every_stepper() {
  std::vector<StepperInfo> rows;
  for (const StepperInfo& row : stepper_table()) {
    if (!row.only_table) rows.push_back(row);
  }
  return testing::ValuesIn(rows);
}

inline std::string stepper_name(const testing::TestParamInfo<StepperInfo>& row) {
  return row.param.name;
}

}  // namespace test
}  // namespace polhode
