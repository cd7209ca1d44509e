// SPDX-License-Identifier: MIT
// Adds file and line, or the option concerned, to errors that only know the key of the scene.
#pragma once

#include "base/error.h"
#include "scene/scene.h"

namespace polhode {

// The error with file and line of its key added or, if an option has overridden the value of that
// key, with the option instead of the key. Errors without a key or with a file are returned
// unchanged.
Error placed(const Scene& scene, const Error& error);

// Returns work(). An Error that it throws is rethrown as placed(); other exceptions pass unchanged.
template <class Work>
auto with_place(const Scene& scene, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw placed(scene, error);
  }
}

}  // namespace polhode
