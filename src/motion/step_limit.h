// SPDX-License-Identifier: MIT
// The longest stable step of a method on a motion, where theory gives one.
#pragma once

#include "motion/stepper_table.h"

namespace polhode {

// How fast the angular momentum circles in the body, rad/s, around the axis of the least or of the
// greatest moment, from Euler's equations linearised about that axis. 0 if it does not circle.
double oscillation_rate(const BodyModel& model, const State& start);

// The step (s) beyond which the method is unstable or its step has no solution, from the rates at
// the start: StepperInfo::limit_turn (rad) divided by the rate that StepperInfo::limit_of names,
// which is oscillation_rate() or |omega|. Infinite if theory gives no limit or that rate is 0. The
// limits are in motion/stepper_table.cpp.
double step_limit(const StepperInfo& method, const BodyModel& model, const State& start);

}  // namespace polhode
