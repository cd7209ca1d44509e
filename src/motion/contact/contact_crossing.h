// SPDX-License-Identifier: MIT
// Where a step of a body on a table first makes a margin zero, also one that is positive at the
// step's end.
#pragma once

#include <optional>

#include "motion/contact/contact_step.h"

namespace polhode {

// A step that has been taken: from where, how long (s), and how (see ContactStepper::step).
struct TakenStep {
  const Touch& touch;
  double t;
  double h;
  const OnTable& from;
  bool implicit;
};

// A part of the step (s) after which a margin is negative that has been positive and will be so
// again; the first such margin that is found. `seen`: the margins at the inner stages, and at the
// end; they are put in order. They tell by their curvature which margins may come down to zero
// between them; those are looked at after parts of the step, ever closer where they may still do
// so.
std::optional<double> dip_within(const ContactStepper& stepper,
                                 const TakenStep& step,
                                 MarginsSeen& seen);

struct Crossing {
  double h;  // from the beginning of the step, s
  ContactEvent event;
};

// The zero within the first `h` (s) of an explicit step, after which a margin is negative.
Crossing crossing_in(const ContactStepper& stepper, const TakenStep& step, double h);

}  // namespace polhode
