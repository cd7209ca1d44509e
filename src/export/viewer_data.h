// SPDX-License-Identifier: MIT
// What viewers in pages show beside a model.
#pragma once

#include "base/json.h"
#include "film/solving.h"

namespace polhode {

// What a viewer shows beside the model: its times ("from", "to", s of motion; "scale", s of motion
// per s of film; "fps"), the stops of the story ("pauses": "at", s of motion, and "caption") and
// its words ("captions", likewise), what it shows and hides
// ("story": "at", lists "show" and "hide" of elements), "series" of |Omega| (rad/s), |L| (kg m^2/s)
// and energy (J) at "times" (s of motion) between which straight lines show them in so many
// "digits", the vertical ("up", in the axes of glTF), the curves of show.plots ("plots"; values at
// equal steps from 0 to "to"), and what elements are ("elements"). Throws Error (check_failed) as
// Motion::at does, and (input) as first_times() in export/key_times.h.
Json viewer_data(const Solved& solved, double from, double to);

}  // namespace polhode
