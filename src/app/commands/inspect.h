// SPDX-License-Identifier: MIT
// The command `inspect`: the mass properties of a body, how its motion is computed, and what theory
// says about it.
#pragma once

#include <filesystem>
#include <string>

#include "base/json.h"
#include "film/overrides.h"
#include "film/solved_scene.h"

namespace polhode {

// The options of `inspect`.
struct InspectJob {
  std::filesystem::path scene;
  Overrides overrides;
  bool json = false;  // true: JSON, false: aligned columns
};

// The values as JSON, with their unit as suffix of the key; docs/inspect.md explains each.
// Vectors are in body axes B. Principal moments are in ascending order, about the point that
// "reference" names; "principal_axes" are their unit vectors in the same order.
// "evaluations_of_ode" counts those of an extra run with the model "ode" to the same accuracy, of
// a long motion extrapolated from a run of its beginning, but no finer than 1e-12 rad; it is null
// if that run fails, as when it cannot reach the accuracy. If the motion itself was computed with
// the model "ode" or "ode6", it is the count of that run. Throws Error (interrupted).
Json inspection(const Solved& solved);

// The output of the command: aligned columns, with angles and rates also in degrees, or indented
// JSON. Throws Error as load_with_overrides and solve do, and (interrupted).
std::string inspect(const InspectJob& job);

}  // namespace polhode
