// SPDX-License-Identifier: MIT
#include "motion/stepper.h"

#include "base/check.h"

namespace polhode {

double Stepper::step_with_error(double, double, State&, Work&) const {
  CHECK(false && "only adaptive methods estimate their error");
  return 0.0;
}

}  // namespace polhode
