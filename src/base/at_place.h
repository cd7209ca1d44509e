// SPDX-License-Identifier: MIT
// Tells the errors of a piece of work where they are.
#pragma once

#include "base/error.h"

namespace polhode {

// Runs `work`; its errors get what is still unknown of their place. An interruption has none.
template <class Work>
decltype(auto) at_place(const Place& place, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    if (error.fault() == Fault::interrupted) throw;
    throw error.at(place);
  }
}

}  // namespace polhode
