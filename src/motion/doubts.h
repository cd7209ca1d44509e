// SPDX-License-Identifier: MIT
// Doubts about a motion that do not come from its method: what rounding errors of its start, its
// body and its loads may do to it. Each is a sentence for the user, absent unless the attitude may
// be off by more than accuracy_rad. Durations in s.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "motion/conditioning.h"
#include "motion/motion.h"
#include "motion/trajectory.h"

namespace polhode {

// What rounding errors of the start or, of an integration, of its steps do.
std::optional<std::string> doubt_of_conditioning(const Conditioning& found,
                                                 bool closed_form,
                                                 double accuracy_rad);

// Of a closed form: angles are rates times the time, so that what is rounded off a rate (rad/s)
// grows with the duration. Goes into `found`, too.
std::optional<std::string> doubt_of_length(double rate,
                                           double duration,
                                           double accuracy_rad,
                                           Conditioning& found);

// Of a closed form: what the moments that count as equal differ by (BodyModel::left_out).
std::optional<std::string> doubt_of_kind(const BodyModel& model,
                                         const State& start,
                                         double duration,
                                         double accuracy_rad);

// What lever arms have that count as none (BodyModel::torque_left_out).
std::optional<std::string> doubt_of_arms(const BodyModel& model,
                                         const State& start,
                                         double duration,
                                         double accuracy_rad);

// What the last digits of time do where strong loads begin and end: ramps have those of their ends,
// and a pulse of a few digits has any number of them.
std::optional<std::string> doubt_of_switches(const BodyModel& model,
                                             double duration,
                                             double accuracy_rad);

// What round-off of the moments and of the centre of mass does (moved_by_rounding() in
// model/body_model.h), if that may be much: small moments beside large ones have the errors of
// these where axes were turned or moved. `solve` finds the motion of another body and start as
// `found` was found; one_rounding is what one rounding does to it, rad. Throws Error (interrupted).
using Solve = std::function<std::shared_ptr<const Trajectory>(const BodyModel&, const State&)>;
std::optional<std::string> doubt_of_body(const BodyModel& model,
                                         const MotionSpec& motion,
                                         const State& start,
                                         const Trajectory& found,
                                         const Solve& solve,
                                         double one_rounding,
                                         double accuracy_rad);

}  // namespace polhode
