// SPDX-License-Identifier: MIT
// The line on stderr with which render, join and preview say what they did.
#pragma once

#include <functional>
#include <string>

#include "app/made.h"
#include "cli/shared_options.h"

namespace polhode {

// "film.mp4: 600 frames in 12.3 s (48.8 frames/s)"
std::string closing_line(const Made& made, double seconds);

// The same as one JSON object: the keys of a progress line, with output and seconds.
std::string closing_json(const Made& made, double seconds);

// Runs `make`, and prints the line in the form that the options ask for; with --quiet, nothing.
// Returns the exit code.
int make_and_tell(const ProgressOptions& options, const std::function<Made()>& make);

}  // namespace polhode
