// SPDX-License-Identifier: MIT
#include "motion/stepper.h"

#include "base/check.h"
#include "base/error.h"
#include "base/nearest.h"
#include "motion/steppers/all.h"

namespace polhode {

double Stepper::step_with_error(double, double, State&) {
  CHECK(false && "only adaptive methods estimate their error");
  return 0.0;
}

const std::vector<StepperInfo>& stepper_table() {
  // clang-format off
  static const std::vector<StepperInfo> table = {
      // name, order, adaptive, keeps energy, |y|, L in space, reversible, takes loads, source, make
      {"explicit_euler",    1, false, false, false, false, false, true,  "Euler 1768; kept to show how it fails", make_explicit_euler},
      {"rk4",               4, false, false, false, false, false, true,  "Kutta 1901", make_rk4},
      {"implicit_midpoint", 2, false, true,  true,  true,  true,  false, "Hairer, Lubich, Wanner, Geometric Numerical Integration, IV.1 and VII.5", make_implicit_midpoint},
      {"dopri5",            5, true,  false, false, false, false, true,  "Dormand and Prince, J. Comput. Appl. Math. 6 (1980) 19", make_dopri5},
  };
  // clang-format on
  return table;
}

const StepperInfo& find_stepper(const std::string& name) {
  std::vector<std::string> names;
  for (const StepperInfo& row : stepper_table()) {
    if (row.name == name) return row;
    names.push_back(row.name);
  }
  throw input_error("no method is called '{}'{}", name, suggestion(name, names));
}

}  // namespace polhode
