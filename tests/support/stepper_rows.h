// SPDX-License-Identifier: MIT
// The rows of the stepper table as parameters of tests, named by the method.
#pragma once

#include <ostream>

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
  return testing::ValuesIn(stepper_table());
}

inline std::string stepper_name(const testing::TestParamInfo<StepperInfo>& row) {
  return row.param.name;
}

}  // namespace test
}  // namespace polhode
