// SPDX-License-Identifier: MIT
#include "motion/stepper.h"

#include "base/check.h"
#include "base/error.h"

namespace polhode {

void Stepper::leap(const Leap* leaps, int count) const {
  for (const Leap* one = leaps; one != leaps + count; ++one)
    part_of_step(one->t, one->h, one->whole, *one->s);
}

void Stepper::step_within(double t, double h, double, State& s) const {
  step(t, h, s);
}

void Stepper::part_of_step(double t, double h, double whole, State& s) const {
  constexpr int kMostParts = 64;
  for (int parts = 1;; parts *= 2) {
    State now = s;
    const double part = h / parts;
    try {
      for (int i = 0; i < parts; ++i)
        step_within(t + i * part, part, whole, now);
      s = now;
      return;
    } catch (const Error& error) {
      if (error.fault() != Fault::check_failed || parts == kMostParts) throw;
    }
  }
}

double Stepper::step_with_error(double, double, State&, Work&) const {
  CHECK(false && "only adaptive methods estimate their error");
  return 0.0;
}

}  // namespace polhode
