// SPDX-License-Identifier: MIT
// What happens at an event: how the body touches from then on, and with which velocities.
#pragma once

#include <string>

#include "base/error.h"
#include "motion/contact/contact_step.h"

namespace polhode {

// How the body touches at the start of a motion: by the laws of friction at its velocities.
Touch first_touch(const ContactStepper& stepper, double t, OnTable& now);

// The result of an event.
struct ContactChange {
  Touch touch;
  // After a bounce that is too low for its height to be told from round-off: how long it takes, s.
  double flies_for = 0.0;
  bool bounces_end = false;  // it was the last of bounces without end
  // By how much a body that is laid on a face would still have moved: rad, and of its reach.
  double left_out_rad = 0.0;
};

// An Error (check_failed): at t (s) the body would have to be held to roll on while nothing presses
// it to the table.
Error held_without_pressure(double t);

// Changes `now` at the event at t (s). Throws Error (check_failed) for a second contact, for a body
// that still moves when a face comes down on the table, and as reaction_of does.
ContactChange change_at(
    const ContactStepper& stepper, ContactEvent event, const Touch& before, double t, OnTable& now);

// The event as a phrase, such as "the contact stops slipping".
std::string words_for(ContactEvent event);
// Its name in reports, such as "slip_ends".
std::string name_of(ContactEvent event);

}  // namespace polhode
