// SPDX-License-Identifier: MIT
// Adds file and line to errors that only know the key of the scene.
#pragma once

#include "base/error.h"
#include "scene/scene.h"

namespace polhode {

// The error with its key replaced by file and line, or by the option that has overridden the key.
// Errors without a key or with a file are returned unchanged.
Error placed(const Scene& scene, const Error& error);

// Runs `work` and rethrows its Errors as placed().
template <class Work>
auto with_place(const Scene& scene, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw placed(scene, error);
  }
}

}  // namespace polhode
