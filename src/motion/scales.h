// SPDX-License-Identifier: MIT
// Typical sizes of a motion, from its start: what steps and errors are measured in.
#pragma once

#include "model/body_model.h"

namespace polhode {

// How fast the motion changes: a sum of the rates that the start, gravity and the loads give,
// rad/s.
double typical_rate(const BodyModel& model, const State& start);

// A typical size of the angular momentum, for error norms: kg m^2/s, never 0.
double momentum_scale(const BodyModel& model, const State& start);

// The first step that an adaptive method of that order tries: the larger, the less is asked of it.
double first_step(const BodyModel& model, const State& start, double tolerance, int order);

// How far two states of the body are apart: the angle between their attitudes, rad, or if larger
// that between their places in radii of gyration. NaN if one of them is.
double deviation(const BodyModel& model, const State& a, const State& b);

}  // namespace polhode
