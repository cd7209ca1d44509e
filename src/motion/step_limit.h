// SPDX-License-Identifier: MIT
// The longest step of a method on a motion, where theory knows one.
#pragma once

#include "motion/stepper_table.h"

namespace polhode {

// How fast the angular momentum goes round in the body, rad/s: about the axis of the least or of
// the greatest moment, by Euler's equations linearised about it; 0 where it rests.
double oscillation_rate(const BodyModel& model, const State& start);

// Beyond this step, in s, the method is unstable or has no solution; infinite where theory gives no
// limit. From the rates of the start.
double step_limit(const StepperInfo& method, const BodyModel& model, const State& start);

}  // namespace polhode
