// SPDX-License-Identifier: MIT
// Errors that know only a key get the place where its value was written.
#pragma once

#include "base/error.h"
#include "scene/scene.h"

namespace polhode {

// The error with the place of its key: file and line, or the option that the value came from.
Error placed(const Scene& scene, const Error& error);

// Runs `work`; an Error without a file gets its place in the scene.
template <class Work>
auto with_place(const Scene& scene, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw placed(scene, error);
  }
}

}  // namespace polhode
