// SPDX-License-Identifier: MIT
// Typical scales of a motion, estimated from its start, to choose steps and to normalise errors.
#pragma once

#include "model/body_model.h"

namespace polhode {

// How fast the attitude changes, rad/s: the sum of the rates due to the initial spin, gravity and
// the loads; 0 for a body at rest that nothing turns.
double typical_rate(const BodyModel& model, const State& start);

// By how much the attitude changes in the duration (s), rad: that rate times the duration, but
// switched loads count only while they act.
double typical_turn(const BodyModel& model, const State& start, double duration);

// How far what BodyModel::left_out leaves out may turn the body in the duration (s), rad. The spin
// about the axis of the least moment I grows by left_out w^2 / I at most; where the body is
// `steadily` turned about that axis, it comes and goes.
double turn_left_out(const BodyModel& model, const State& start, double duration, bool steadily);

// The same of BodyModel::torque_left_out.
double turn_by_arms_left_out(const BodyModel& model, const State& start, double duration);

// A typical angular momentum for error norms, kg m^2/s; never 0.
double momentum_scale(const BodyModel& model, const State& start);

// The same of the linear momentum, kg m/s: what goes with `angular_momentum` (kg m^2/s) at the
// radius of gyration, or what the forces will give the body on a way of that length.
double linear_momentum_scale(const BodyModel& model, double angular_momentum);

// The first step (s) to try with an adaptive method of that order and that tolerance (relative
// local error per step, positive); infinite for a body at rest that nothing turns.
double first_step(const BodyModel& model, const State& start, double tolerance, int order);

// How much faster damping is than the rest of the motion: the fastest rate of damping, over the
// other rates of typical_rate() or, if that is more, over 1 / duration (s). Far above 1: stiff.
double stiffness(const BodyModel& model, const State& start, double duration);

}  // namespace polhode
