// SPDX-License-Identifier: MIT
// What an implicit step says when it finds no solution: never a number.
#pragma once

#include <cmath>
#include <string>

#include "base/error.h"
#include "model/body_model.h"

namespace polhode {

// Error (check failed) with time, step, how far the body turns in it, and the limit of the method.
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
