// SPDX-License-Identifier: MIT
#include "motion/stepper.h"

#include "base/check.h"

namespace polhode {

void Stepper::leap(const Leap* leaps, int count) const {
  for (const Leap* one = leaps; one != leaps + count; ++one)
    step_within(one->t, one->h, one->whole, *one->s);
}

void Stepper::step_within(double t, double h, double, State& s) const {
  step(t, h, s);
}

double Stepper::step_with_error(double, double, State&, Work&) const {
  CHECK(false && "only adaptive methods estimate their error");
  return 0.0;
}

}  // namespace polhode
