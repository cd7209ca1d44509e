// SPDX-License-Identifier: MIT
// The last line on stderr of render, join and preview.
#pragma once

#include <functional>
#include <string>

#include "app/made.h"
#include "cli/shared_options.h"

namespace polhode {

// "film.mp4: 600 frames in 12.3 s (48.8 frames/s)".
std::string closing_line(const Made& made, double seconds);

// The same as one JSON object: the keys of a JSON progress line, plus output and seconds.
std::string closing_json(const Made& made, double seconds);

// Runs `make`, then prints the line in the form that the options ask for (nothing with --quiet).
// Returns the exit code 0. Throws what `make` throws, and Error (input) naming --progress.
int make_and_tell(const ProgressOptions& options, const std::function<Made()>& make);

}  // namespace polhode
