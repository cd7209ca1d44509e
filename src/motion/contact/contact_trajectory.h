// SPDX-License-Identifier: MIT
// Integrates the motion of a body on a table from event to event.
#pragma once

#include "motion/grid_trajectory.h"

namespace polhode {

// The most events of a motion; a body that bounces for ever has more.
inline constexpr int kMostContactEvents = 20'000;

// As integrate_adaptive() in motion/grid_trajectory.h, for a model with a table. The
// equations change at events (motion/contact/contact_change.h), which are located on the steps of
// the method itself: at() makes one partial step from the grid time before, as there, and an event
// is where such a step makes a margin zero. Throws Error (check_failed) as change_at does, and for
// more than kMostContactEvents events.
Integration integrate_on_table(const StepperInfo& method,
                               const BodyModel& model,
                               const State& start,
                               double duration,
                               double tolerance,
                               const Effort& effort);

}  // namespace polhode
