// SPDX-License-Identifier: MIT
// The error of a step that has no solution.
#pragma once

#include <cmath>
#include <string>

#include "base/error.h"
#include "model/body_model.h"

namespace polhode {

// An Error (check_failed) without a place, whose message has the name of the method, the time t
// (s), the step h (s), the angle by which the body turns in it, and `limit`, the step limit of the
// method in words. y: angular momentum in P, kg m^2/s.
inline Error no_solution(const std::string& method,
                         double t,
                         double h,
                         const BodyModel& model,
                         const Vec3& y,
                         const std::string& limit) {
  return {Fault::check_failed,
          fmt::format("{} found no solution of its step at t = {:.6g} s with step {} s; h |omega| "
                      "is {:.3g} rad there, {}",
                      method,
                      t,
                      h,
                      std::abs(h) * angular_velocity(model, y).norm(),
                      limit)};
}

}  // namespace polhode
