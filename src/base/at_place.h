// SPDX-License-Identifier: MIT
// Adds the place (file, line, key) to errors that are thrown by code that does not know it.
#pragma once

#include "base/error.h"

namespace polhode {

// Returns work(). An Error that it throws is rethrown with the missing parts of its place filled in
// from `place`; Error (interrupted) and exceptions of other types pass unchanged.
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
