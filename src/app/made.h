// SPDX-License-Identifier: MIT
// What a command has made, for the line that it ends with.
#pragma once

#include <string>

namespace polhode {

struct Made {
  std::string output;       // as the user named it
  int frames = 0;           // that were made for it
  int every = 1;            // the output has every n-th of them
  int from_earlier = 0;     // of them, kept from earlier runs
  bool is_picture = false;  // pictures, not a film
  int parts = 0;            // that were joined; 0: nothing was
};

}  // namespace polhode
