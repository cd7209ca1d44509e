// SPDX-License-Identifier: MIT
// The last line that render, join and preview write to stderr: what was made, and how fast.
#pragma once

#include <functional>
#include <string>

#include "app/made.h"
#include "cli/shared_options.h"

namespace polhode {

// The line as text, without line break: "film.mp4: 600 frames in 12.3 s (48.8 frames/s)"; a
// single picture has no rate. `seconds`: wall time of the run; the rate counts the frames of this
// run only.
std::string closing_line(const Made& made, double seconds);

// The line as one JSON object, without line break: the keys of a line of `--progress json`
// (docs/render.md), in which "done" and "total" are Made::frames, plus "output", "frames" (in the
// output) and "seconds". `seconds`: wall time of the run.
std::string closing_json(const Made& made, double seconds);

// Runs `make`, measures its time, and prints the line to stderr: as JSON with `--progress json`,
// not at all with --quiet, else as text. Returns the exit code 0. Throws what `make` throws, and
// before it runs Error (input), with --progress as key, for an unknown kind of progress.
int make_and_tell(const ProgressOptions& options, const std::function<Made()>& make);

}  // namespace polhode
