// SPDX-License-Identifier: MIT
// What friction cannot hold: which of slip, rolling and turning about the vertical begin, and in
// which directions.
#pragma once

#include "motion/contact/contact_step.h"

namespace polhode {

// The touch without what the laws of friction cannot hold at t (s), where `now` has the velocities
// that it holds. What it lets go grows in its direction, and the rest is held, if there is such a
// choice; each of them changes what the others need. `given_way`: what an event has just found at
// its limit, which is let go in any case; null without one. Throws Error (check_failed) as
// reaction_of does.
Touch let_go(const ContactStepper& stepper,
             const Touch& touch,
             double t,
             const OnTable& now,
             const ContactEvent* given_way);

}  // namespace polhode
