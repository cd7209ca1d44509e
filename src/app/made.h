// SPDX-License-Identifier: MIT
// What a command has made, for its closing line.
#pragma once

#include <string>

namespace polhode {

// Counts of one output.
struct Made {
  std::string output;       // as the user named it
  int frames = 0;           // number of frames made for it
  int every = 1;            // the output contains every n-th of them
  int from_earlier = 0;     // how many of them earlier runs made
  bool is_picture = false;  // the output is pictures, not a film
  int parts = 0;            // number of joined parts; 0: nothing was joined
};

}  // namespace polhode
