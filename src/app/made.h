// SPDX-License-Identifier: MIT
// What `render`, `join` or `preview` has made, for the closing line of the command.
#pragma once

#include <string>

namespace polhode {

// The counts of one output.
struct Made {
  std::string output;       // as the user named it; "-": standard output
  int frames = 0;           // number of frames drawn for it, in this run, earlier runs and parts
  int from_earlier = 0;     // how many of these frames earlier runs have made (--resume)
  bool is_picture = false;  // true: the output is one picture, not a film or a sequence
  int parts = 0;            // number of parts that were joined; 0: nothing was joined
};

}  // namespace polhode
